// Grid maps from a seed: the same map for the same seed, everywhere.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <taut/geometry/occupancy_grid.h>

namespace taut {

/// What the free cells look like.
enum class GridKind {
  /// Corridors one cell wide between walls one cell wide; a spanning tree by depth-first search with backtracking
  maze,
  /// rooms of about 7 x 7 cells, walls one cell wide, most with a door of one cell; a tenth of the walls has none
  rooms,
  random,  ///< every cell blocked with probability 1/4
};

/// `maze`, `rooms`, `random`
std::string_view name(GridKind kind);
/// Nothing for any other word.
std::optional<GridKind> grid_kind_named(std::string_view word);

/// Throws InputError unless 1 <= width, height <= 20000. At least one cell is free. O(cells).
OccupancyGrid generate_grid(GridKind kind, std::uint32_t width, std::uint32_t height, std::uint64_t seed);

}  // namespace taut
