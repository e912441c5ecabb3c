// taut mouse run: one robot, one maze, both runs.
#include <taut/cli/command_line.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/mouse/report.h>
#include <taut/cli/run.h>

namespace taut::cli {

namespace {

struct RunOptions {
  MazeOptions maze;
  CommonOptions common;
  micromouse::Explorer explorer = micromouse::Explorer::score;
  int max_steps = micromouse::kMaxSteps;
  MouseReport report;
};

void add_options(CommandLine& app, RunOptions& options) {
  add_maze_options(app, options.maze);
  add_explorer_options(app, options.explorer);
  add_max_steps_option(app, options.max_steps);
  add_report_options(app, options.report, options.common);
  app.example("taut mouse run maze.maz --explorer prove --certificate proof.json --svg runs.svg");
}

micromouse::Record record_of(const RunOptions& options, const GridMaze& maze) {
  const auto robot =
      micromouse::make_explorer(options.explorer, micromouse::task_of(maze, options.max_steps), options.common.seed);
  return micromouse::run_trial(maze, *robot, options.max_steps);
}

int run(const RunOptions& options, Run& run) {
  options.report.promise(run);
  run.source(options.maze.file);
  const GridMazeInput read = run.stage("read", [&] { return read_mouse_maze(options.maze.file, options.maze.format); });
  const auto yardsticks = run.stage("optimum", [&] { return micromouse::yardsticks(read.maze); });
  if (!yardsticks) return no_route(read.name, run);
  MouseTrial trial{run.stage("run", [&] { return record_of(options, read.maze); }), *yardsticks};
  trial.explorer = name(options.explorer);
  trial.seed = options.common.seed;
  return options.report.end(run, read, std::move(trial));
}

}  // namespace

Command mouse_run_command(CommandLine& group) {
  return command<RunOptions>(group, "run", "Run 1 explores, run 2 races: the score, beside what is possible",
                             add_options, run);
}

}  // namespace taut::cli
