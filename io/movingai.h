// Maps and scenarios of the MovingAI benchmark sets (Sturtevant, "Benchmarks for grid-based pathfinding", 2012).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/occupancy_grid.h>

namespace taut {

/// `type octile`, `height H`, `width W`, `map`, then H rows of W characters: `.` `G` `S` free, `@` `O` `T` `W` blocked. Throws InputError.
OccupancyGrid read_movingai_map(std::string_view text, const std::string& source);

struct Scenario {
  std::uint32_t bucket;
  std::string map;
  std::uint32_t width, height, start_column, start_row, goal_column, goal_row;
  double optimal;
  std::string optimal_text;
  std::size_t line;
};

/// `version 1`, then a scenario a line. Throws InputError.
std::vector<Scenario> read_movingai_scenarios(std::string_view text, const std::string& source);
std::string movingai_scenario_text(const std::vector<Scenario>& scenarios);
std::string movingai_map_text(const OccupancyGrid& grid);

}  // namespace taut
