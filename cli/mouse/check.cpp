// taut mouse check: is it a legal competition maze? With --certificate: does this file prove what it says about the
// maze?
#include <fmt/format.h>

#include <optional>

#include <taut/cli/command_line.h>
#include <taut/cli/messages.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/run.h>
#include <taut/geometry/errors.h>
#include <taut/io/worlds/certificate_file.h>
#include <taut/robots/micromouse/legality.h>

namespace taut::cli {

namespace {

using micromouse::MazeRules;

struct CheckOptions {
  MazeOptions maze;
  CommonOptions common;
  std::optional<MazeRules> rules;  // when given
  std::string certificate;
};

MazeRules rules_of(const std::string& word) {
  if (word == "competition") return MazeRules::competition;
  if (word == "free-posts") return MazeRules::free_posts;
  if (word == "course") throw UsageError("'course' is free-posts here; did you mean `--rules free-posts`?");
  throw UsageError("'" + word + "' is not competition or free-posts");
}

void add_options(CommandLine& app, CheckOptions& options) {
  add_maze_options(app, options.maze);
  app.add_option_function(
         "--rules", [&options](const std::string& word) { options.rules = rules_of(word); },
         "Whose rules (default: competition; free-posts where a side has 12 or 14 cells)")
      .type_name("NAME");
  app.add_option("--certificate", options.certificate, "Check this file of `taut mouse run --certificate` instead")
      .type_name("FILE");
  app.callback([&options] {
    if (options.certificate == "-" && options.maze.file == "-")
      throw UsageError("MAZE and --certificate cannot both be standard input");
  });
  app.explain("Rules", {{"competition", "16 x 16 or 32 x 32; up to 16 a side every post carries a wall"},
                        {"free-posts", "12, 14 or 16 a side; posts may stand free"}});
  app.example("taut mouse check maze.maz --certificate proof.json");
}

MazeRules rules_for(const CheckOptions& options, const GridMaze& maze) {
  if (options.rules) return *options.rules;
  return maze.width() == 12 || maze.width() == 14 ? MazeRules::free_posts : MazeRules::competition;
}

/// `yes` is the word for what it should be; `remark` goes with it.
int tell(Run& run, const std::string& source, const char* yes, const std::string& remark,
         const std::vector<std::string>& faults) {
  std::string line = faults.empty() ? fmt::format("{}: {}{}\n", source, yes, remark) : "";
  for (const std::string& fault : faults) line += fmt::format("{}: not {}: {}\n", source, yes, fault);
  return run.end({.outcome = faults.empty() ? Outcome::done : Outcome::invalid,
                  .reason = faults.empty() ? "" : faults.front(),
                  .result = {{yes, faults.empty()}, {"faults", faults}},
                  .line = std::move(line)});
}

int check_proof(const CheckOptions& options, Run& run) {
  const GridMazeInput read = run.stage("read", [&] { return read_mouse_maze(options.maze.file, options.maze.format); });
  const std::string name = options.certificate == "-" ? "<stdin>" : options.certificate;
  const auto certified = read_certificate(read_bytes(options.certificate), name);
  const micromouse::Finding finding = run.stage("check", [&] { return verify_certificate(certified, read.maze); });
  const micromouse::Certificate& proof = certified.certificate;
  const std::string remark =
      fmt::format(": no run 2 has fewer than {}, and this one needs no more ({} named)",
                  count_text(static_cast<std::size_t>(proof.steps), "step"), count_text(proof.walls.size(), "wall"));
  return tell(run, read.name, "valid", remark,
              finding ? std::vector<std::string>{} : std::vector<std::string>{finding.reason});
}

int run(const CheckOptions& options, Run& run) {
  run.source(options.maze.file);
  if (!options.certificate.empty()) return check_proof(options, run);
  const GridMazeInput read = run.stage("read", [&] { return read_grid_maze(options.maze.file, options.maze.format); });
  const MazeRules rules = rules_for(options, read.maze);
  auto faults = run.stage("check", [&] { return micromouse::violations(read.maze, rules); });
  if (read.unknown_walls > 0) faults.push_back(count_text(read.unknown_walls, "wall") + " of the drawing unknown");
  return tell(run, read.name, "legal",
              fmt::format(", {} x {}{}", read.maze.width(), read.maze.height(),
                          rules == MazeRules::free_posts ? ", posts may stand free" : ""),
              faults);
}

}  // namespace

Command mouse_check_command(CommandLine& group) {
  return command<CheckOptions>(group, "check", "Is this a legal competition maze? Is this certificate valid?",
                               add_options, run);
}

}  // namespace taut::cli
