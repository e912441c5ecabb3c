// A maze for a car, with roadblocks that may be open or closed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/grid_maze.h>
#include <taut/geometry/point.h>

namespace taut::car {

/// A set of cells that is open or closed as a whole.
struct Roadblock {
  char letter = 'A';
  double open_probability = 0.5;
  std::vector<Cell> cells{};  ///< at least one
};

/// What everybody may know beforehand. Cells count from 1, x is the column and y the row, the first row of a file is y
/// = 1; the unit is a cell. What is beyond the grid is open: only cells are walls.
struct Course {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> walls;    ///< width * height, rows first; 1 = wall. A roadblock's cell is none
  std::vector<Roadblock> roadblocks;  ///< by letter; at most kMostRoadblocks
  Point start;                        ///< the car's centre; its heading is 0
  Point goal;

  static constexpr int kMostRoadblocks = 26;
  bool has(Cell c) const { return c.x >= 1 && c.x <= width && c.y >= 1 && c.y <= height; }
  bool is_wall(Cell c) const { return has(c) && walls[index(c)] != 0; }
  std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.y - 1) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c.x - 1);
  }
};

/// A set of roadblocks, bit i for the i-th.
using RoadblockSet = std::uint32_t;

/// Which roadblocks are open in one drive.
struct Sample {
  int number = 0;
  RoadblockSet open = 0;
};

/// A file: the course, and for scoring alone the samples.
struct RoadMap {
  Course course;
  std::vector<Sample> samples;
};

/// Reads
///
///     start X Y
///     goal X Y
///     roadblock LETTER X Y P_OPEN     any number; without P_OPEN 1/2
///     grid WIDTH HEIGHT
///     HEIGHT rows of WIDTH characters: # wall, . open, a LETTER A..Z: a cell of that roadblock
///     samples K                       optional, what follows on the line is a remark
///     I BITS                          K lines; a character per roadblock in the order of letters, 1 = open
///
///  1. `start`, `goal` and `roadblock` come before `grid`, in any order, start and goal once. A line that begins with #
///     is a comment unless it is one of the grid's rows; empty lines outside the grid are skipped; CRLF and a byte
///     order mark are accepted.
///  2. Strict otherwise. X Y of a roadblock lie within the box around its cells; sides are at most kLargestSide; start
///     and goal lie within the grid.
/// Throws InputError with the line.
RoadMap read_road_map(std::string_view bytes, const std::string& source = {});

inline constexpr int kLargestSide = 1000;

/// The set that the bits, as in a file, name. Throws InputError for a wrong number of bits or another character.
RoadblockSet roadblocks_of(std::string_view bits, const Course& course, const std::string& source = {}, int line = 0);

/// The reverse.
std::string bits_of(RoadblockSet open, const Course& course);

}  // namespace taut::car
