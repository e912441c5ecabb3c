// MovingAI's grid maps and scenarios.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/occupancy_grid.h>

namespace taut {

/// Reads a MovingAI map (`type octile`, `height`, `width`, `map`, rows; free are `.GS`, blocked `OTW@`).
/// Throws InputError.
OccupancyGrid read_movingai_map(std::string_view text, const std::string& source);
/// The map at another size, as its scenarios may ask for: cell (x, y) is that of the map at (x * width / w, y * height
/// / h), rounded down. Preconditions: w and h above 0.
OccupancyGrid scaled(const OccupancyGrid& grid, std::uint32_t w, std::uint32_t h);
/// A line of a scenario: `bucket map width height start goal optimal`. Columns and rows, row 0 at the top; width and
/// height are those of the map, or of what it is scaled to. The length 0 between two places says that there is none.
struct Scenario {
  std::uint32_t bucket;
  std::string map;
  std::uint32_t width, height, start_column, start_row, goal_column, goal_row;
  double optimal;
  std::string optimal_text;
  std::size_t line;
  /// The digits after the point that count: those of `optimal_text`, or more where the file leaves out zeros at the
  /// end, as `%g` does.
  int places;

  /// What one of the last of them is worth.
  double unit() const;
  bool says_none() const;  ///< the length is 0, but the ends differ
};
/// Does this line look like one of a scenario file without `version 1`: nine fields, the
/// second a name, the third to eighth numbers?
bool looks_like_scenario(std::string_view line);
/// A scenario file between cells (octile sets), with or without its first line. Throws InputError with the line.
/// O(bytes).
std::vector<Scenario> read_movingai_scenarios(std::string_view text, const std::string& source);
/// What columns and rows are: of cells in the octile sets, of the corners of cells in the any-angle ones, where the
/// map's far side is one more.
enum class ScenarioPlaces { cells, corners };
/// One line of it, by itself: a length without a point is taken for a whole number, exactly. Throws InputError.
Scenario movingai_scenario(std::string_view line, const std::string& source, int number, ScenarioPlaces places);
/// `version 1`, the first line. Throws InputError when it is not.
void require_movingai_version(std::string_view line, const std::string& source, int number);
/// The scenario file of these (version 1), and the map file.
std::string movingai_scenario_text(const std::vector<Scenario>& scenarios);
std::string movingai_map_text(const OccupancyGrid& grid);

}  // namespace taut
