// Pictures of a micromouse trial.
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/grid_maze.h>
#include <taut/robots/micromouse/speed_run.h>
#include <taut/robots/micromouse/trial.h>

namespace taut {

struct MousePicture {
  std::string title;
  std::vector<std::string> facts;
  bool flood = false;  ///< in each cell the fewest steps to the goal, as the map of run 1 has it (unknown walls open)
};

/// One SVG 1.1 document: cells shaded by the step at which they were first seen, walls that run 1 or 2 saw strong,
/// others dashed, both routes, the mouse where it ended.
std::string mouse_svg(const GridMaze& maze, const micromouse::Record& record, const MousePicture& picture);

/// The same as a film that plays in a browser and begins again (SMIL, no script): the mouse moves, and what it sees
/// appears when it sees it. Where animation is not understood it is the last frame. 0.1 to 0.4 s a step.
std::string mouse_animation(const GridMaze& maze, const micromouse::Record& record, const MousePicture& picture);

/// The fastest run and, below it, the one of the fewest cells.
std::string mouse_speed_svg(const GridMaze& maze, const micromouse::SpeedRun& fastest,
                            const micromouse::SpeedRun& shortest, const std::string& title);

}  // namespace taut
