// taut mouse check: is it a legal competition maze? With --certificate: does this file prove what it says about the
// maze?
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/stop.h>
#include <taut/geometry/errors.h>
#include <taut/io/results/detail/result_values.h>
#include <taut/robots/micromouse/certificate_file.h>
#include <taut/robots/micromouse/legality.h>

namespace taut::cli {

namespace {

using Json = nlohmann::ordered_json;
using micromouse::MazeRules;

struct CheckOptions {
  MazeOptions maze;
  CommonOptions common;
  MazeRules rules = MazeRules::competition;
  std::string certificate;
  std::string json;
};

void add_options(CommandLine& app, CheckOptions& options) {
  add_maze_options(app, options.maze);
  const auto rules = [&options](const std::string& word) {
    if (word != "competition" && word != "course")
      throw UsageError("--rules: '" + word + "' is not competition or course");
    options.rules = word == "course" ? MazeRules::course : MazeRules::competition;
  };
  app.add_option_function(
         "--rules", rules,
         "competition (default): 16 x 16 or 32 x 32, all posts carry walls; course: 12, 14 or 16 a side, free posts")
      .type_name("NAME");
  app.add_option("--certificate", options.certificate, "Check this file of `taut mouse run --certificate` instead")
      .type_name("FILE");
  app.add_option("--json", options.json, "Write the finding as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
}

int tell(const CheckOptions& options, const MouseMaze& read, const char* yes, const char* no, const std::string& remark,
         const std::vector<std::string>& faults) {
  const Json json{{"program", "taut"}, {"source", read.name}, {yes, faults.empty()}, {"faults", faults}};
  finish();
  write_file(options.json, options.json.empty() ? "" : detail::json_text(json));
  if (options.json == "-") return faults.empty() ? kFound : ExitCode::kNone;
  std::string out = faults.empty() ? fmt::format("{}: {}{}\n", read.name, yes, remark) : "";
  for (const std::string& fault : faults) out += fmt::format("{}: {}: {}\n", read.name, no, fault);
  print(out);
  return faults.empty() ? kFound : ExitCode::kNone;
}

int check_proof(const CheckOptions& options, const MouseMaze& read) {
  if (options.certificate == "-" && options.maze.file == "-")
    throw InputError("<stdin>", 0, "cannot be both the maze and the certificate");
  const std::string name = options.certificate == "-" ? "<stdin>" : options.certificate;
  const auto file = micromouse::read_certificate(read_bytes(options.certificate), name);
  const micromouse::Finding finding = check_certificate(file, read.maze);
  const std::string remark = fmt::format(": no run 2 has fewer than {}, and this one needs no more ({} named)",
                                         count_text(static_cast<std::size_t>(file.certificate.steps), "step"),
                                         count_text(file.certificate.walls.size(), "wall"));
  return tell(options, read, "valid", "not valid", remark,
              finding ? std::vector<std::string>{} : std::vector<std::string>{finding.reason});
}

int run(const CheckOptions& options) {
  require_writable(options.json);
  begin_stage("check");
  if (!options.certificate.empty())
    return check_proof(options, read_mouse_maze(options.maze.file, options.maze.format));
  const MouseMaze read = read_grid_maze(options.maze.file, options.maze.format);
  std::vector<std::string> faults = micromouse::violations(read.maze, options.rules);
  if (read.unknown_walls > 0) faults.push_back(count_text(read.unknown_walls, "wall") + " of the drawing unknown");
  return tell(options, read, "legal", "not legal", fmt::format(", {} x {}", read.maze.width(), read.maze.height()),
              faults);
}

}  // namespace

Command mouse_check_command(CommandLine& group) {
  return command<CheckOptions>(group, "check", "Is this a legal competition maze? Is this certificate valid?",
                               add_options, run);
}

}  // namespace taut::cli
