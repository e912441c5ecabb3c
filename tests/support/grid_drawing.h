// Grids drawn in tests: `.` free, `#` blocked, `S` start, `G` goal.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <taut/geometry/occupancy_grid.h>
#include <taut/search/grid/grid_moves.h>

namespace taut::test {

struct DrawnGrid {
  OccupancyGrid grid;
  GridPlace start;
  GridPlace goal;
};

inline DrawnGrid drawn(const std::vector<std::string_view>& rows) {
  DrawnGrid d;
  d.grid.width = static_cast<std::uint32_t>(rows.front().size());
  d.grid.height = static_cast<std::uint32_t>(rows.size());
  for (std::uint32_t row = 0; row < d.grid.height; ++row)
    for (std::uint32_t column = 0; column < d.grid.width; ++column) {
      const char c = rows[row][column];
      d.grid.blocked.push_back(c == '#');
      if (c == 'S') d.start = {row, column};
      if (c == 'G') d.goal = {row, column};
    }
  return d;
}

}  // namespace taut::test
