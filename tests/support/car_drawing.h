// Mazes with roadblocks, drawn.
#pragma once

#include <string>
#include <vector>

#include <taut/io/worlds/roadblock_map.h>

namespace taut::test {

/// A grid without start and goal lines; S and G mark them; roadblocks A.. are all declared with p.
inline roadblocks::RoadblockMap map_of(std::vector<std::string> rows, const std::string& p = "0.5") {
  std::string head;
  for (std::size_t y = 0; y < rows.size(); ++y)
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      char& c = rows[y][x];
      const std::string at = " " + std::to_string(x + 1) + " " + std::to_string(y + 1);
      if (c == 'S' || c == 'G') head += (c == 'S' ? "start" : "goal") + at + "\n", c = '.';
      if (c >= 'A' && c <= 'Z') head += std::string("roadblock ") + c + at + " " + p + "\n";
    }
  head += "grid " + std::to_string(rows[0].size()) + " " + std::to_string(rows.size()) + "\n";
  for (const std::string& row : rows) head += row + "\n";
  return read_roadblock_map(head, "drawing");
}

/// A lane whose wall points are 3 apart, 30 long, closed at its end; a wide way round below.
inline roadblocks::RoadblockMap lane() {
  std::vector<std::string> rows(18, "#" + std::string(48, '.') + "#");
  rows.front() = rows.back() = std::string(50, '#');
  const std::string wall = "#......" + std::string(32, '#') + "..........#";
  for (std::size_t y : {1U, 2U, 3U, 6U, 7U, 8U, 9U}) rows[y] = wall;
  rows[4][4] = 'S';
  rows[4][45] = 'G';
  rows[4][36] = 'A';
  return map_of(rows, "0.9");
}

}  // namespace taut::test
