// taut mouse speed: the fastest way through a known maze, beside the shortest.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/mouse/sheet.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/stop.h>
#include <taut/io/results/detail/result_values.h>
#include <taut/robots/micromouse/speed_run.h>

namespace taut::cli {

namespace {

using Json = nlohmann::ordered_json;
using micromouse::Aim;
using micromouse::Drive;
using micromouse::SpeedModel;
using micromouse::SpeedRun;

struct SpeedOptions {
  MazeOptions maze;
  CommonOptions common;
  std::string model;
  std::string svg;
  std::string json;
  bool drives = false;
  bool quiet = false;
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
  app.add_option("--json", options.json, "Write everything as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_flag("--quiet,-q", options.quiet, "No table on standard output").group("Output");
  app.callback([&options] {
    if (options.svg == "-" && options.json == "-")
      throw UsageError("--svg - and --json - cannot both have standard output");
  });
}

struct SpeedReport {
  MouseMaze read;
  SpeedModel model;
  SpeedRun fastest;
  SpeedRun shortest;
};

std::size_t turns_of(const SpeedRun& run) {
  return static_cast<std::size_t>(std::count_if(run.drives.begin(), run.drives.end(),
                                                [](const Drive& d) { return d.kind != Drive::Kind::straight; }));
}

double top_speed_of(const SpeedRun& run, const SpeedModel& model) {
  double top = 0;
  for (const Drive& d : run.drives) {
    top = std::max({top, d.speed_in, d.speed_out});
    if (d.kind != Drive::Kind::straight) continue;
    const micromouse::Ramp& ramp = (d.heading & 1) != 0 ? model.diagonal : model.straight;
    top = std::max(top, micromouse::peak_speed(ramp, d.speed_in, d.speed_out, d.metres));
  }
  return top;
}

/// Places where the two leave each other and meet again: cells, and how many of the shortest lie between.
struct Parting {
  Cell from, to;
  std::size_t fastest = 0;
  std::size_t shortest = 0;
};

/// Both begin and end together or the ends of the lists stand for it.
std::vector<Parting> partings(const std::vector<Cell>& fastest, const std::vector<Cell>& shortest) {
  std::map<Cell, std::size_t> place;
  for (std::size_t k = 0; k < shortest.size(); ++k) place.emplace(shortest[k], k);
  std::vector<Parting> all;
  std::size_t f = 0, s = 0;
  while (f + 1 < fastest.size() && s + 1 < shortest.size()) {
    if (fastest[f + 1] == shortest[s + 1]) {
      ++f, ++s;
      continue;
    }
    std::size_t k = f + 1;
    while (k + 1 < fastest.size() && !(place.contains(fastest[k]) && place[fastest[k]] > s)) ++k;
    const auto met = place.find(fastest[k]);
    const std::size_t again = met != place.end() && met->second > s ? met->second : shortest.size() - 1;
    all.push_back({fastest[f], fastest[k], k - f, again - s});
    f = k, s = again;
  }
  return all;
}

std::string row(const char* name, const SpeedRun& run, const SpeedModel& model) {
  return fmt::format("  {:<10}{:>9.3f}{:>9.2f}{:>7}{:>7}{:>9.2f}\n", name, run.seconds, run.metres,
                     run.cells.size() - 1, turns_of(run), top_speed_of(run, model));
}

std::string table(const SpeedReport& r) {
  std::string out = fmt::format("{}: {} x {}\n  {:<10}{:>9}{:>9}{:>7}{:>7}{:>9}\n", r.read.name, r.read.maze.width(),
                                r.read.maze.height(), "", "s", "m", "cells", "turns", "top m/s");
  out += row("fastest", r.fastest, r.model) + row("shortest", r.shortest, r.model);
  const auto parts = partings(r.fastest.cells, r.shortest.cells);
  if (parts.empty()) return out + "  the fastest is the shortest\n";
  for (const Parting& p : parts)
    out += fmt::format("  from {} to {}: {} instead of {}\n", cell_text(p.from), cell_text(p.to),
                       count_text(p.fastest, "cell"), p.shortest);
  return out;
}

const char* heading_name(unsigned heading) {
  static constexpr const char* kNames[] = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
  return kNames[heading & 7];
}

std::string drives_text(const SpeedRun& run) {
  std::string out;
  for (const Drive& d : run.drives)
    out += fmt::format(
        "{:<12} {:>5.1f},{:<5.1f} -> {:>5.1f},{:<5.1f} {:<2} -> {:<2} {:>7.3f} m {:>7.3f} s {:>6.2f} -> {:.2f} m/s\n",
        name(d), d.from.x / 2.0, d.from.y / 2.0, d.to.x / 2.0, d.to.y / 2.0, heading_name(d.heading),
        heading_name(d.after), d.metres, d.seconds, d.speed_in, d.speed_out);
  return out;
}

Json json_of(const SpeedRun& run) {
  Json drives = Json::array(), cells = Json::array();
  for (const Cell c : run.cells) cells.push_back({c.x, c.y});
  for (const Drive& d : run.drives)
    drives.push_back({{"kind", name(d)},
                      {"from", {d.from.x / 2.0, d.from.y / 2.0}},
                      {"to", {d.to.x / 2.0, d.to.y / 2.0}},
                      {"heading", heading_name(d.heading)},
                      {"after", heading_name(d.after)},
                      {"speed_in", d.speed_in},
                      {"speed_out", d.speed_out},
                      {"metres", d.metres},
                      {"seconds", d.seconds}});
  return {{"seconds", run.seconds}, {"metres", run.metres}, {"cells", run.cells.size() - 1},
          {"turns", turns_of(run)}, {"route", cells},       {"drives", drives}};
}

Json json_of(const SpeedReport& r) {
  Json parts = Json::array();
  for (const Parting& p : partings(r.fastest.cells, r.shortest.cells))
    parts.push_back(
        {{"from", {p.from.x, p.from.y}}, {"to", {p.to.x, p.to.y}}, {"fastest", p.fastest}, {"shortest", p.shortest}});
  return {{"program", "taut"},
          {"version", TAUT_VERSION},
          {"source", r.read.name},
          {"fastest", json_of(r.fastest)},
          {"shortest", json_of(r.shortest)},
          {"differences", parts}};
}

std::string line_of(const MouseSheet& sheet, const SpeedRun& run) {
  std::vector<Point> points;
  for (const Drive& d : run.drives) {
    const auto line = micromouse::trace(d, 0.1);
    points.insert(points.end(), line.begin(), line.end());
  }
  return points.size() < 2 ? "" : MouseSheet::path(sheet.line(points));
}

std::string picture(const SpeedReport& r) {
  const auto fact = [](const char* what, const SpeedRun& run) {
    return fmt::format("{} {:.3f} s, {:.2f} m, {} cells", what, run.seconds, run.metres, run.cells.size() - 1);
  };
  using enum detail::SvgKey::Sample;
  const MouseSheet sheet(r.read.maze, title_of(r.read.name), {fact("fastest", r.fastest), fact("shortest", r.shortest)},
                         {{"fastest", "fastest", line, {}},
                          {"run2", "shortest", line, {}},
                          {"goal", "goal", patch, {}},
                          {"start", "start", patch, {}}});
  std::string walls;
  for (const auto& w : standing_walls(r.read.maze)) walls += sheet.wall(w);
  return sheet.head() + sheet.goal() + sheet.start() + MouseSheet::group("seen", MouseSheet::path(walls)) +
         sheet.posts() + MouseSheet::group("run2", line_of(sheet, r.shortest)) +
         MouseSheet::group("fastest", line_of(sheet, r.fastest)) + sheet.foot();
}

int run(const SpeedOptions& options) {
  require_writable(options.svg);
  require_writable(options.json);
  begin_stage("read");
  SpeedReport report{read_mouse_maze(options.maze.file, options.maze.format), {}, {}, {}};
  if (!options.model.empty()) report.model = micromouse::read_speed_model(read_bytes(options.model), options.model);
  begin_stage("search");
  const auto fastest = micromouse::speed_run(report.read.maze, report.model);
  if (!fastest) return no_route(report.read.name);
  report.fastest = *fastest;
  report.shortest = *micromouse::speed_run(report.read.maze, report.model, Aim::fewest_cells);
  const std::string drawing = options.svg.empty() ? "" : picture(report);
  const std::string json = options.json.empty() ? "" : detail::json_text(json_of(report));
  finish();
  write_file(options.svg, drawing);
  write_file(options.json, json);
  if (!options.quiet && options.svg != "-" && options.json != "-") print(table(report));
  if (options.drives) print(drives_text(report.fastest));
  return kFound;
}

}  // namespace

Command mouse_speed_command(CommandLine& group) {
  return command<SpeedOptions>(group, "speed", "The fastest run with smooth turns and diagonals, beside the shortest",
                               add_options, run);
}

}  // namespace taut::cli
