// What was walked, as doubles.
#pragma once

#include <taut/robots/bug/detail/heading.h>
#include <vector>

namespace taut::bug::detail {

/// A point where the robot can be, next to the exact place: in the closed triangle where the stand is, or a vertex.
Point rounded(const Triangulation& tri, const Stand& stand);

/// Builds a path whose legs stay in the triangles that the exact way passes.
class Trail {
 public:
  Trail(const Triangulation& tri, Point from) : tri_(tri), points_{from} {}

  /// Along a walk to `end`. Precondition: the walk begins where the trail ends.
  void add(const Walk& walk, Point end);
  /// A point of the same triangle.
  void add(Point p) {
    if (points_.back() != p) points_.push_back(p);
  }
  /// Counts what rounding the place can add to the length.
  void add_rounding(const ExactPoint& exact, Point p) { rounding_ += 2 * taut::displacement(exact, p); }

  const std::vector<Point>& points() const { return points_; }
  double rounding() const { return rounding_; }

 private:
  bool goes_straight(Point from, Point to, const std::vector<std::uint32_t>& triangles) const;

  const Triangulation& tri_;
  std::vector<Point> points_;
  double rounding_ = 0;
};

}  // namespace taut::bug::detail
