// Mazes as in a contest: many loops, and yet a long way to the goal.
#pragma once

#include <cstdint>
#include <optional>

#include <taut/geometry/grid_maze.h>

namespace taut::micromouse {

inline constexpr double kContestWalls = 0.38;  ///< share of the interior walls that stand

/// What is asked of a maze.
struct ContestShape {
  int side = 16;             ///< even, 4 at least (precondition)
  int steps = 25;            ///< of a shortest run 2, at least
  bool one_entrance = true;  ///< of the goal room; else as it happens
};

/// A perfect maze by depth-first search, the goal room in its middle closed but for one drawn side; then walls are
/// taken down in drawn order until `kContestWalls` of the interior ones stand, but for those without which run 2 would
/// have fewer than `steps` steps. All cells are reached; the start keeps its one way out. The same seed gives the same
/// maze. Nothing when the seed's maze is too short from the start, or when too few walls could be taken down (a second
/// seed helps). O(walls * one search).
std::optional<GridMaze> contest_maze(const ContestShape& shape, std::uint64_t seed);

}  // namespace taut::micromouse
