// taut mouse run: one robot, one maze, both runs.
#include <fmt/format.h>

#include <stdexcept>

#include <taut/cli/command_line.h>
#include <taut/cli/messages.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/mouse/table.h>
#include <taut/cli/run.h>
#include <taut/io/pictures/mouse_svg.h>
#include <taut/io/worlds/certificate_file.h>

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
  std::string certificate;
  bool quick = false;
};

void require_one_standard_output(const RunOptions& options) {
  int taken = 0;
  for (const std::string* file : {&options.svg, &options.animation, &options.common.json, &options.certificate})
    taken += *file == "-" ? 1 : 0;
  if (taken > 1) throw UsageError("only one output can have standard output");
}

void add_options(CommandLine& app, RunOptions& options) {
  add_maze_options(app, options.maze);
  add_explorer_options(app, options.explorer);
  add_max_steps_option(app, options.max_steps);
  app.add_option("--svg", options.svg, "Write a picture of both runs; - is standard output")
      .type_name("FILE")
      .group("Output");
  add_animate_option(app, options.animation, "Write a film of both runs that plays in a browser (SVG, no script)");
  app.add_flag("--flood", options.flood, "Write into the pictures how many steps each cell is from the goal")
      .group("Output");
  app.add_option("--certificate", options.certificate,
                 "Write the proof that run 2 is optimal, for `taut mouse check`; exit code 4 when run 1 has none")
      .type_name("FILE")
      .group("Output");
  app.add_flag("--quick", options.quick, "Leave out the floor with proof and benchmark 2").group("Output");
  app.callback([&app, &options] {
    settle_animation(app, options.animation, options.svg, options.common.json);
    require_one_standard_output(options);
  });
  app.example("taut mouse run maze.maz --explorer prove --certificate proof.json --svg runs.svg");
}

void require(const Finding& finding, const char* what) {
  if (!finding) throw std::logic_error(fmt::format("the {} does not pass its own check: {}", what, finding.reason));
}

MouseTrial trial_of(const RunOptions& options, const GridMaze& maze, const micromouse::Yardsticks& yardsticks) {
  MouseTrial trial;
  trial.yardsticks = yardsticks;
  trial.explorer = name(options.explorer);
  trial.seed = options.common.seed;
  const auto robot =
      micromouse::make_explorer(options.explorer, micromouse::task_of(maze, options.max_steps), options.common.seed);
  trial.record = micromouse::run_trial(maze, *robot, options.max_steps);
  trial.certificate = micromouse::certificate(trial.record);
  return trial;
}

void check(const MouseTrial& trial, const GridMaze& maze) {
  require(verify_record(trial.record, maze), "trial");
  if (trial.certificate) require(verify_certificate(*trial.certificate, maze, trial.record), "certificate");
}

// Those that take many trials or a search. What is finished stays if the next is stopped.
void measure(MouseTrial& trial, const GridMazeInput& read, Run& run) {
  micromouse::Yardsticks& y = trial.yardsticks;
  if (micromouse::fit_for_proof_bound(read.maze)) {
    y.with_proof = run.stage("floor", [&] { return micromouse::proof_bound(read.maze); });
    run.so_far(mouse_trial_json(trial), mouse_table(trial, read.name));
  } else {
    note(fmt::format("taut: {}: too large for the floor with proof", read.name));
  }
  y.random_walkers = run.stage("walkers", [&] { return micromouse::benchmark_random_walkers(read.maze); });
  y.walked = true;
}

std::vector<std::string> facts_of(const MouseTrial& trial) {
  const Record& record = trial.record;
  return {trial.explorer + " explorer",
          record.score() ? fmt::format("score {:.3f}", *record.score()) : std::string(name(record.status)),
          fmt::format("run 1: {}", record.run1), fmt::format("run 2: {}", record.run2),
          fmt::format("optimum {}{}", trial.yardsticks.optimum, trial.certificate ? ", proven" : "")};
}

// Pictures whatever came of it, the proof where there is one.
std::vector<OutputFile> files_of(const RunOptions& options, const GridMazeInput& read, const MouseTrial& trial) {
  const MousePicture picture{title_of(read.name), facts_of(trial), options.flood};
  std::vector<OutputFile> files;
  if (!options.svg.empty()) files.push_back({options.svg, mouse_svg(read.maze, trial.record, picture)});
  if (!options.animation.empty())
    files.push_back({options.animation, mouse_animation(read.maze, trial.record, picture)});
  if (trial.certificate && !options.certificate.empty())
    files.push_back({options.certificate, certificate_text(certified_run(*trial.certificate, trial.record))});
  return files;
}

// Empty when all that was asked for is there.
std::string what_is_missing(const RunOptions& options, const MouseTrial& trial) {
  if (trial.record.status != TrialStatus::finished)
    return fmt::format("{}: {}", trial.explorer, name(trial.record.status));
  if (options.certificate.empty() || trial.certificate) return "";
  return "run 1 does not prove a route; no certificate written (--explorer prove explores until it does)";
}

int run(const RunOptions& options, Run& run) {
  for (const std::string& file : {options.svg, options.animation, options.certificate}) run.promise(file);
  run.source(options.maze.file);
  const GridMazeInput read = run.stage("read", [&] { return read_mouse_maze(options.maze.file, options.maze.format); });
  const auto yardsticks = run.stage("optimum", [&] { return micromouse::yardsticks(read.maze); });
  if (!yardsticks) return no_route(read.name, run);
  MouseTrial trial = run.stage("run", [&] { return trial_of(options, read.maze, *yardsticks); });
  run.stage("check", [&] { check(trial, read.maze); });
  run.so_far(mouse_trial_json(trial), mouse_table(trial, read.name));
  if (!options.quick) measure(trial, read, run);
  const std::string missing = what_is_missing(options, trial);
  if (!missing.empty()) complain(read.name + ": " + missing);
  return run.end({.outcome = missing.empty() ? Outcome::found : Outcome::unproven,
                  .reason = missing,
                  .result = mouse_trial_json(trial),
                  .line = mouse_table(trial, read.name),
                  .files = files_of(options, read, trial)});
}

}  // namespace

Command mouse_run_command(CommandLine& group) {
  return command<RunOptions>(group, "run", "Run 1 explores, run 2 races: the score, beside what is possible",
                             add_options, run);
}

}  // namespace taut::cli
