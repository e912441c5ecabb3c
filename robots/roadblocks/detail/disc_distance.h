// Closed cells, and how far a disc inside the car is from the goal.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <taut/robots/roadblocks/drive.h>

namespace taut::roadblocks::detail {

/// A course with its closed roadblocks decided.
class Obstacles {
 public:
  Obstacles(const Course& course, RoadblockSet closed, WallReading reading);

  /// The same with these closed too.
  Obstacles with(RoadblockSet closed) const;

  const Course& course() const { return *course_; }
  WallReading reading() const { return reading_; }
  bool is_closed(Cell c) const { return course_->has(c) && closed_[course_->index(c)] != 0; }

  /// Does the step stay clear, by `slack`, of all closed cells?
  bool is_clear(const Pose& from, double control, const Pose& to, double slack) const;

  /// Does the car standing there, wider by `slack` on all sides, touch nothing closed?
  bool is_free(const Pose& pose, double slack) const;

  /// A lower bound of the distance from the point to what is closed, 0 outside of the grid.
  double room(Point p) const;

  /// Gates between two closed points exactly 2 apart, straight across or down: visit(band), around the gate by kBand on
  /// both sides, where no centre of a car can be.
  template <typename Visit>
  void each_gate(Visit visit) const;
  static constexpr double kBand = 0.25;

 private:
  void lessen_room(Cell closed);
  bool is_inside(Point p) const;  ///< of the grid
  template <typename Test>
  bool none_near(Point p, double reach, Test test) const;

  const Course* course_;
  WallReading reading_;
  std::vector<std::uint8_t> closed_;
  std::vector<float> room_;  ///< of raster cells of 1/kRaster, a lower bound for all their points
};

template <typename Visit>
void Obstacles::each_gate(Visit visit) const {
  const auto add = [&](Point from, Point to, bool down) {
    visit(Box{{from.x - (down ? kBand : 0), from.y - (down ? 0 : kBand)},
              {to.x + (down ? kBand : 0), to.y + (down ? 0 : kBand)}});
  };
  for (int y = 1; y <= course_->height; ++y)
    for (int x = 1; x <= course_->width; ++x) {
      if (!is_closed({x, y})) continue;
      if (reading_ == WallReading::points) {
        const Point p{static_cast<double>(x), static_cast<double>(y)};
        if (is_closed({x + 2, y})) add(p, {p.x + 2, p.y}, false);
        if (is_closed({x, y + 2})) add(p, {p.x, p.y + 2}, true);
        continue;
      }
      // Squares face each other as far as both extend; at a corner's level in the least.
      for (const int shift : {-1, 0, 1}) {
        const double low = std::max(-0.5, shift - 0.5), high = std::min(0.5, shift + 0.5);
        if (is_closed({x + 3, y + shift})) add({x + 0.5, y + low}, {x + 2.5, y + high}, false);
        if (is_closed({x + shift, y + 3})) add({x + low, y + 0.5}, {x + high, y + 2.5}, true);
      }
    }
}

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

}  // namespace taut::roadblocks::detail
