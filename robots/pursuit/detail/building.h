// Floor plans from a seed, and costs that rise towards walls.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/geometry/draws.h>

namespace taut::pursuit::detail {

/// x_size * y_size cells, y fastest, 1 where there is a wall: an outer wall, corridors of 12 to 30 cells that halve the
/// building again and again, rooms between them, doors of 8 to 20 cells. Smaller where the map is small. Preconditions:
/// sizes >= 3.
std::vector<std::uint8_t> building(int x_size, int y_size, taut::Draws& draws);

/// For each cell 1 + 10 * the number of cells with a wall in the square of 2 * radius + 1 cells around it. O(cells).
std::vector<std::uint32_t> inflated(const std::vector<std::uint8_t>& walls, int x_size, int y_size, int radius);

}  // namespace taut::pursuit::detail
