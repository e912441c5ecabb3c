// Closed cells, and how far a disc inside the car is from the goal.
#pragma once

#include <cmath>
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

  /// Does the step stay clear, by `slack`, of all closed cells?
  bool is_clear(const Pose& from, double control, const Pose& to, double slack) const;

  /// Does the car standing there, wider by `slack` on all sides, touch nothing closed?
  bool is_free(const Pose& pose, double slack) const;

  /// A lower bound of the distance from the point to what is closed, 0 outside of the grid.
  double room(Point p) const;

 private:
  void measure_room();
  template <typename Test>
  bool none_near(Point p, double reach, Test test) const;

  const Course* course_;
  WallReading reading_;
  std::vector<std::uint8_t> closed_;
  std::vector<float> room_;  ///< of raster cells of 1/kRaster, a lower bound for all their points
};

inline constexpr int kRaster = 4;  ///< raster cells a unit

/// The raster: cell (0, 0) begins at (0.5, 0.5), so that the grid's unit squares are kRaster cells wide.
inline int raster(double v) { return static_cast<int>(std::floor((v - 0.5) * kRaster)); }
inline double middle(int i) { return 0.5 + (i + 0.5) / kRaster; }

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
