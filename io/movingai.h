// MovingAI's grid maps and scenarios.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/occupancy_grid.h>

namespace taut {

/// Reads a MovingAI map (`type octile`, `height`, `width`, `map`, rows; `.` `G` `S` free, `@` `O` `T` `W` blocked). Throws InputError.
OccupancyGrid read_movingai_map(std::string_view text, const std::string& source);
/// A line of a scenario: `bucket map width height start goal optimal`. Columns and rows, row 0 at the top.
struct Scenario {
  std::uint32_t bucket;
  std::string map;
  std::uint32_t width, height, start_column, start_row, goal_column, goal_row;
  double optimal;
  std::string optimal_text;
  std::size_t line;
};
std::vector<Scenario> read_movingai_scenarios(std::string_view text, const std::string& source);
/// The scenario file of these (version 1), and the map file.
std::string movingai_scenario_text(const std::vector<Scenario>& scenarios);
std::string movingai_map_text(const OccupancyGrid& grid);

}  // namespace taut
