// What is told of a trial, whoever the robot was: the table, pictures, the proof.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <taut/cli/command_line.h>
#include <taut/cli/options.h>
#include <taut/cli/run.h>
#include <taut/cli/world/grid_maze_input.h>
#include <taut/io/pictures/mouse_svg.h>
#include <taut/io/results/mouse_json.h>

namespace taut::cli {

struct MouseReport {
  std::string svg;
  std::string animation;
  bool flood = false;
  std::string values;
  std::string certificate;
  bool quick = false;

  void promise(Run& run) const;

  /// Checks the trial by its own rules (a defect where it fails), measures what is possible, and writes it all. Gives
  /// the exit code: 4 where the robot did not finish, or a proof was asked for that run 1 does not hold. `missing`:
  /// why the robot did not finish, where its record cannot say. `listing`: in the place of the table, with --quiet too.
  int end(Run& run, const GridMazeInput& read, MouseTrial trial, std::string missing = {}, std::string listing = {},
          const std::map<Cell, micromouse::CellMark>& marks = {}) const;
};

/// --svg, --animate, --flood, --values, --certificate, --quick.
void add_report_options(CommandLine& app, MouseReport& report, const CommonOptions& common);

}  // namespace taut::cli
