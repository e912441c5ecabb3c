// taut mouse speed: the fastest way through a known maze, beside the shortest.
#include <fmt/format.h>

#include <stdexcept>

#include <taut/cli/command_line.h>
#include <taut/cli/messages.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/run.h>
#include <taut/io/pictures/mouse_svg.h>
#include <taut/io/results/mouse_json.h>
#include <taut/io/worlds/speed_model_file.h>
#include <taut/robots/micromouse/speed_facts.h>
#include <taut/robots/micromouse/speed_runs.h>

namespace taut::cli {

namespace {

using micromouse::Drive;
using micromouse::SpeedModel;
using micromouse::SpeedRun;

struct SpeedOptions {
  MazeOptions maze;
  CommonOptions common;
  std::string model;
  std::string svg;
  bool drives = false;
};

void add_options(CommandLine& app, SpeedOptions& options) {
  add_maze_options(app, options.maze);
  app.add_option("--model", options.model,
                 "How fast the mouse is, as JSON; data/mouse_speed.json is what it is without this")
      .type_name("FILE")
      .group("Robot");
  app.add_flag("--drives", options.drives, "Print the straights and turns of the fastest run, one a line")
      .group("Output");
  app.add_option("--svg", options.svg, "Write a picture of both; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.callback([&options] {
    if (options.svg == "-" && options.common.json == "-")
      throw UsageError("--svg - and --json - cannot both have standard output");
  });
  app.example("taut mouse speed maze.maz --svg speed.svg");
}

std::string row(const char* name, const SpeedRun& run, const SpeedModel& model) {
  return fmt::format("  {:<10}{:>9.3f}{:>9.2f}{:>7}{:>7}{:>9.2f}\n", name, run.seconds, run.metres,
                     run.cells.size() - 1, turns_of(run), top_speed_of(run, model));
}

std::string bound_row(const char* name, double seconds, const std::string& metres, const std::string& of) {
  return fmt::format("  {:<10}{:>9.3f}{:>9}  {}\n", name, seconds, metres, of);
}

std::string table(const GridMazeInput& read, const SpeedModel& model, const micromouse::SpeedRuns& runs) {
  std::string out = fmt::format("{}: {} x {}\n  {:<10}{:>9}{:>9}{:>7}{:>7}{:>9}\n", read.name, read.maze.width(),
                                read.maze.height(), "", "s", "m", "cells", "turns", "top m/s");
  out +=
      row("fastest", runs.fastest, model) + row("steady", runs.steady, model) + row("shortest", runs.shortest, model);
  out += bound_row("bound", runs.bound, "", "no run on such lines takes less, at whatever speeds");
  out += bound_row("any curve", runs.any_curve.seconds, fmt::format("{:.2f}", runs.any_curve.metres),
                   "no drive takes less: any curve through the gaps, turning free");
  const auto parts = micromouse::partings(runs.fastest.cells, runs.shortest.cells);
  if (parts.empty()) return out + "  the fastest is the shortest\n";
  for (const micromouse::Parting& p : parts)
    out += fmt::format("  from {} to {}: {} instead of {}\n", cell_text(p.from), cell_text(p.to),
                       count_text(p.fastest, "cell"), p.shortest);
  return out;
}

std::string drives_text(const SpeedRun& run) {
  std::string out;
  for (const Drive& d : run.drives)
    out += fmt::format(
        "{:<12} {:>5.1f},{:<5.1f} -> {:>5.1f},{:<5.1f} {:<2} -> {:<2} {:>7.3f} m {:>7.3f} s {:>6.2f} -> {:.2f} m/s\n",
        name(d), d.from.x / 2.0, d.from.y / 2.0, d.to.x / 2.0, d.to.y / 2.0, micromouse::heading_name(d.heading),
        micromouse::heading_name(d.after), d.metres, d.seconds, d.speed_in, d.speed_out);
  return out;
}

int run(const SpeedOptions& options, Run& run) {
  run.promise(options.svg);
  run.source(options.maze.file);
  const GridMazeInput read = run.stage("read", [&] { return read_mouse_maze(options.maze.file, options.maze.format); });
  SpeedModel model;
  if (!options.model.empty()) model = read_speed_model(read_bytes(options.model), options.model);
  const auto runs = run.stage("search", [&] { return micromouse::speed_runs(read.maze, model); });
  if (!runs) return no_route(read.name, run);
  if (runs->bound > runs->fastest.seconds || runs->any_curve.seconds > runs->fastest.seconds)
    throw std::logic_error("the fastest run is below its own bound");
  Answer answer{.outcome = Outcome::found, .result = mouse_speed_json(*runs), .line = table(read, model, *runs)};
  if (options.drives) answer.listing = drives_text(runs->fastest);
  if (!options.svg.empty())
    answer.files.push_back(
        {options.svg, mouse_speed_svg(read.maze, runs->fastest, runs->shortest, title_of(read.name))});
  return run.end(std::move(answer));
}

}  // namespace

Command mouse_speed_command(CommandLine& group) {
  return command<SpeedOptions>(group, "speed", "The fastest run with smooth turns and diagonals, beside the shortest",
                               add_options, run);
}

}  // namespace taut::cli
