// The world of a grid map.
#pragma once

#include <functional>
#include <string>

#include <taut/geometry/occupancy_grid.h>
#include <taut/geometry/world.h>

namespace taut {

/// In the map's own coordinates: cell (column c, row r) is the box [c, c + 1] x [r, r + 1], y grows downwards
/// (World::y_down). The outer border is walled. Every piece of blocked cells that hang together by sides is one solid,
/// its outline traced around whole runs of cells; solids that touch at a corner leave no way between them. Throws
/// InputError when there are no cells. O(1); the outlines, when they are first asked for, O(cells), and O(n log n) for
/// n corners.
World world_of(OccupancyGrid grid, std::string source = {});

/// The same, with the cells' corners elsewhere and y upwards, for others to add ends to: `corner(column, row)`, column
/// 0 to width, row 0 to height. Rows and columns stay straight lines, one beside the other (precondition).
WorldParts parts_of(const OccupancyGrid& grid, const std::function<Point(std::uint32_t, std::uint32_t)>& corner,
                    std::string source);

}  // namespace taut
