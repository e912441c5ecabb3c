// Closed cells, and how far a disc inside the car is from the goal.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/robots/car/drive.h>

namespace taut::car::detail {

/// A course with its closed roadblocks decided.
class Obstacles {
 public:
  Obstacles(const Course& course, RoadblockSet closed, WallReading reading);

  const Course& course() const { return *course_; }
  WallReading reading() const { return reading_; }
  bool is_closed(Cell c) const { return course_->has(c) && closed_[course_->index(c)] != 0; }

  /// Does the step stay clear, by kMargin, of all closed cells and within the grid's neighbourhood?
  bool is_clear(const Pose& from, double control, const Pose& to) const;

  /// A lower bound of the distance from the point to what is closed, 0 outside of the grid.
  double room(Point p) const;

 private:
  void measure_room();

  const Course* course_;
  WallReading reading_;
  std::vector<std::uint8_t> closed_;
  std::vector<float> room_;  ///< of raster cells of 1/kRaster, a lower bound for all their points
};

inline constexpr int kRaster = 4;  ///< raster cells a unit

/// Ways of the disc on the raster, from everywhere to the goal.
class DiscDistance {
 public:
  DiscDistance(const Obstacles& obstacles, Point goal);

  bool reaches(Point p) const { return steps_from(p) != kFar; }
  int steps_from(Point p) const;  ///< forward steps; kFar when there is no way
  static constexpr int kFar = 1 << 29;

 private:
  int columns_ = 0, rows_ = 0;
  std::vector<int> steps_;
};

}  // namespace taut::car::detail
