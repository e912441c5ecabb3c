// Is a maze one that a contest may use?
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/grid_maze.h>

namespace taut::micromouse {

/// Whose rules a maze is held against.
enum class MazeRules {
  competition,  ///< of the classic and the half-size contest
  free_posts,   ///< 12, 14 or 16 a side; posts may stand free
};

/// What a maze breaks of the rules, one line each, in this order; nothing of a legal one.
///  1. Size: 16 x 16 or 32 x 32 (free_posts: 12, 14 or 16 a side).
///  2. The border is closed: each opening is named.
///  3. The start is a corner, closed on three sides and open to the north; the wall on its right, between it and the
///     next cell, among them.
///  4. The goal is one room of at least one cell, with no wall inside, away from the start; 2 x 2 in the middle where
///     the side is 16 or less.
///  5. The goal can be reached from the start.
///  6. At least one wall touches each inner post, but for posts inside the goal room, which stand free (competition, up
///     to 16 a side: in half-size finals posts are left out).
/// O(cells).
std::vector<std::string> violations(const GridMaze& maze, MazeRules rules = MazeRules::competition);

}  // namespace taut::micromouse
