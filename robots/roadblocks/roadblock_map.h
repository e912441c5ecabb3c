// A maze for a car, with roadblocks that may be open or closed.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/geometry/grid_maze.h>
#include <taut/geometry/point.h>

namespace taut::roadblocks {

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

/// The maze, and for scoring alone the samples.
struct RoadblockMap {
  Course course;
  std::vector<Sample> samples;
};

inline constexpr int kLargestSide = 1000;  ///< cells

}  // namespace taut::roadblocks
