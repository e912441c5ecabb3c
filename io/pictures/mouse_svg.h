// Pictures of a micromouse trial.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <taut/geometry/grid_maze.h>
#include <taut/robots/micromouse/mms.h>
#include <taut/robots/micromouse/speed_run.h>
#include <taut/robots/micromouse/trial.h>

namespace taut {

struct MousePicture {
  std::string title;
  std::vector<std::string> facts;
  /// In each cell the fewest steps to the goal, as the map of run 1 has it (unknown walls open).
  bool flood = false;
  std::map<Cell, micromouse::CellMark> marks{};  ///< what the robot wrote, on the still picture
};

/// One SVG 1.1 document: cells shaded by the step at which they were first seen, walls that run 1 or 2 saw strong,
/// others dashed, both routes, the mouse where it ended.
std::string mouse_svg(const GridMaze& maze, const micromouse::Record& record, const MousePicture& picture);

/// The same as a film that plays in a browser and begins again (SMIL, no script): the mouse moves, and what it sees
/// appears when it sees it; with `flood` the numbers change as its map does. Where animation is not understood it is
/// the last frame. 0.1 to 0.4 s a step.
std::string mouse_animation(const GridMaze& maze, const micromouse::Record& record, const MousePicture& picture);

/// What the robot hopes for, before, during and after exploring: three pictures with `flood` side by side, as things
/// stood before the first step, when run 1 first reached the goal (half way through it, where that was its end), and at
/// the end of run 1.
std::string mouse_values_svg(const GridMaze& maze, const micromouse::Record& record, const MousePicture& picture);

/// The fastest run and, below it, the one of the fewest cells.
std::string mouse_speed_svg(const GridMaze& maze, const micromouse::SpeedRun& fastest,
                            const micromouse::SpeedRun& shortest, const std::string& title);

}  // namespace taut
