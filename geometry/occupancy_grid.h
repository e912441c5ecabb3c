// A raster of free and blocked cells, as grid maps have it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace taut {

/// Cells in rows, row 0 at the top: cell (column, row) is at row * width + column. 1 is blocked, 0 is free.
struct OccupancyGrid {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> blocked;

  bool contains(std::int64_t column, std::int64_t row) const {
    return column >= 0 && row >= 0 && column < width && row < height;
  }
  /// What lies outside is blocked.
  bool free(std::int64_t column, std::int64_t row) const {
    return contains(column, row) &&
           blocked[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] == 0;
  }
};

}  // namespace taut
