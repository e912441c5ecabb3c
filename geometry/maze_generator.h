// Mazes from a seed: the same maze for the same seed, everywhere.
#pragma once

#include <cstdint>

#include <taut/geometry/grid_maze.h>

namespace taut {

/// A perfect maze: a spanning tree grown under a checkerboard of biases.
///
///  1. Cell (row, col) of the source, both from 1, is Cell{col - 1, row - 1}: row 1 is the bottom row, the source's
///     "up" (row - 1) leads towards smaller y.
///  2. Until all cells are in region 1: of 15 cells drawn uniformly, take the one outside region 1 with the least row +
///     col (the first drawn among equals); draw d in 1 .. 8, reduced to a direction by the parity of its block; if the
///     wall in that direction stands between two regions, take it down and join them under the smaller id.
///  3. Two border walls are open: left of the first cell and right of the last. The maze has no goal: a path goes from
///     opening to opening (World, guarantee 5).
/// Blocks have side min(rows, cols) / nb, not rounded. Region 1 is kept as a flag a cell, members as circular lists, so
/// a step costs O(1) but for joins; O(n log n) expected steps for n cells.
/// Throws InputError unless 1 <= rows, cols <= 20000 and rows * cols < 2^32.
GridMaze generate_biased_maze(int rows, int cols, std::uint64_t seed);

/// A perfect maze by depth-first search with backtracking from the bottom left cell (iterative). Long corridors, closed
/// border; start bottom left, goal the top right cell. O(n). Throws InputError as above.
GridMaze generate_backtracker(int width, int height, std::uint64_t seed);

/// Takes down a share of the walls that stand between two cells: round(share * count) of them, every choice equally
/// likely. O(n). Throws InputError unless 0 <= share <= 1.
void open_walls(GridMaze& maze, double share, std::uint64_t seed);

/// Makes the room in the middle the goal, as in micromouse mazes: no wall is left between its cells. O(1).
void open_centre_room(GridMaze& maze);

}  // namespace taut
