// Worlds that are mazes of unit cells, or unions of them, whatever they were read from. Private.
#pragma once

#include <string_view>

#include <taut/geometry/grid_maze.h>
#include <taut/geometry/occupancy_grid.h>
#include <taut/geometry/world.h>

namespace taut::detail {

/// The maze with these walls: world_of() of it has the same walls, limits and ends. Throws InputError, naming what
/// `format` would lose: walls off the sides of unit cells or with a thickness, solids, floor plans, ends that are no
/// middles of cells or no rooms of them, a goal point that is no implied one.
GridMaze maze_of(const World& world, std::string_view format);

/// The cells that are blocked, row 0 at the least y: solids and what lies outside the areas. Throws InputError, naming
/// what `format` would lose: corners that are none of unit cells from (0, 0) on, walls, limits that are open.
OccupancyGrid cells_of(const World& world, std::string_view format);

}  // namespace taut::detail
