// taut mouse run: one robot, one maze, both runs.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/messages.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/mouse/report.h>
#include <taut/cli/mouse/svg.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/robots/micromouse/certificate_file.h>

namespace taut::cli {

namespace {

using micromouse::Finding;
using micromouse::Record;
using micromouse::TrialStatus;

struct RunOptions {
  MazeOptions maze;
  CommonOptions common;
  micromouse::Explorer explorer = micromouse::Explorer::score;
  int max_steps = micromouse::kMaxSteps;
  std::string svg;
  std::string animation;
  bool flood = false;
  std::string json;
  std::string certificate;
  bool quick = false;
  bool quiet = false;

  std::vector<const std::string*> files() const { return {&svg, &animation, &json, &certificate}; }
};

void add_options(CommandLine& app, RunOptions& options) {
  add_maze_options(app, options.maze);
  add_explorer_options(app, options.explorer);
  app.add_option("--max-steps", options.max_steps, "Of both runs together (default: 1000)")
      .type_name("N")
      .range(1, 1'000'000)
      .group("Robot");
  app.add_option("--svg", options.svg, "Write a picture of both runs; - is standard output")
      .type_name("FILE")
      .group("Output");
  add_animate_option(app, options.animation, "Write a film of both runs that plays in a browser (SVG, no script)");
  app.add_flag("--flood", options.flood, "Write into the pictures how many steps each cell is from the goal")
      .group("Output");
  app.add_option("--json", options.json, "Write everything as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_option("--certificate", options.certificate,
                 "Write the proof that run 2 is optimal, for `taut mouse check`; exit code 4 when run 1 has none")
      .type_name("FILE")
      .group("Output");
  app.add_flag("--quick", options.quick, "Leave out the floor with proof and benchmark 2").group("Output");
  app.add_flag("--quiet,-q", options.quiet, "No table on standard output").group("Output");
  app.callback([&app, &options] {
    settle_animation(app, options.animation, options.svg, options.json);
    int taken = 0;
    for (const std::string* file : options.files()) taken += *file == "-" ? 1 : 0;
    if (taken > 1) throw UsageError("only one output can have standard output");
  });
}

void require(const Finding& finding, const char* what) {
  if (!finding) throw std::logic_error(fmt::format("the {} does not pass its own check: {}", what, finding.reason));
}

MouseReport report_of(const RunOptions& options, const MouseMaze& read) {
  MouseReport report;
  report.source = read.name;
  report.explorer = name(options.explorer);
  report.seed = options.common.seed;
  const micromouse::Task task = micromouse::task_of(read.maze, options.max_steps);
  const auto robot = micromouse::make_explorer(options.explorer, task, options.common.seed);
  report.record =
      timed("run", report.seconds, [&] { return micromouse::run_trial(read.maze, *robot, options.max_steps); });
  require(micromouse::check_record(report.record, read.maze), "trial");
  report.certificate = micromouse::certificate(report.record);
  if (report.certificate)
    require(micromouse::check_certificate(*report.certificate, read.maze, report.record), "certificate");
  const micromouse::WallMap map = map_after_run1(report.record);
  report.walls_seen = map.seen();
  report.walls = map.seen() + map.unknown();
  return report;
}

bool stdout_taken(const RunOptions& options) {
  for (const std::string* file : options.files())
    if (*file == "-") return true;
  return false;
}

std::vector<std::string> facts_of(const MouseReport& report) {
  const Record& record = report.record;
  return {report.explorer + " explorer",
          record.score() ? fmt::format("score {:.3f}", *record.score()) : std::string(name(record.status)),
          fmt::format("run 1: {}", record.run1), fmt::format("run 2: {}", record.run2),
          fmt::format("optimum {}{}", report.yardsticks.optimum, report.certificate ? ", proven" : "")};
}

int run(const RunOptions& options) {
  for (const std::string* file : options.files()) require_writable(*file);
  begin_stage("read");
  const MouseMaze read = read_mouse_maze(options.maze.file, options.maze.format);
  begin_stage("yardsticks");
  if (!options.quick && !fit_for_proof_bound(read.maze))
    note(fmt::format("taut: {}: too large for the floor with proof", read.name));
  const auto measures = yardsticks(read.maze, !options.quick);
  if (!measures) return no_route(read.name);
  MouseReport report = report_of(options, read);
  report.yardsticks = *measures;
  begin_stage("write");
  const MousePicture picture{title_of(read.name), facts_of(report), options.flood};
  const std::string drawing = options.svg.empty() ? "" : mouse_svg(read.maze, report.record, picture);
  const std::string film = options.animation.empty() ? "" : mouse_animation(read.maze, report.record, picture);
  const std::string json = options.json.empty() ? "" : mouse_json(report);
  const std::string proof = report.certificate && !options.certificate.empty()
                                ? certificate_text(micromouse::file_of(*report.certificate, report.record))
                                : "";
  finish();
  write_file(options.svg, drawing);
  write_file(options.animation, film);
  write_file(options.json, json);
  if (!proof.empty()) write_file(options.certificate, proof);
  if (!options.quiet && !stdout_taken(options)) print(mouse_table(report));
  if (report.record.status != TrialStatus::finished) {
    complain(fmt::format("{}: {}: {}", read.name, report.explorer, name(report.record.status)));
    return kStopped;
  }
  if (options.certificate.empty() || report.certificate) return kFound;
  complain(read.name +
           ": run 1 does not prove a route; no certificate written (--explorer prove explores until it does)");
  return kStopped;
}

}  // namespace

Command mouse_run_command(CommandLine& group) {
  return command<RunOptions>(group, "run", "Run 1 explores, run 2 races: the score, beside what is possible",
                             add_options, run);
}

}  // namespace taut::cli
