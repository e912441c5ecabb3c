// Where the tangents of a circle around a corner can lead.
#pragma once

#include <algorithm>
#include <cmath>

#include <taut/geometry/point.h>

namespace taut {

/// A path that bends around a corner of walls has all of them on one side. So its legs have the direction of one of two
/// opposite cones (for a bend to the left and one to the right), outside of the angle that the walls span, and of that
/// angle's opposite. A leg leaves or passes the centre at the distance r and arrives as far from the other centre, so
/// what it leads to lies within 2r of such a cone. In doubles, wide enough to miss nothing.
class TautCones {
 public:
  /// Everything.
  TautCones() = default;
  /// Of circles of no size around c, whose walls span the angle from the direction of `first` counter-clockwise to that
  /// of `last`, below half a turn.
  TautCones(Point c, Point first, Point last)
      : first_(direction(c, first)), last_(direction(c, last)), rounding_(1e-14 * (std::abs(c.x) + std::abs(c.y))) {
    is_bounded_ = first_.x * last_.y - first_.y * last_.x > kSlack;
  }

  /// Of circles of any radius up to r.
  TautCones reaching(double r) const {
    TautCones cones = *this;
    cones.reach_ = 2 * r * (1 + 1e-9) + rounding_;
    return cones;
  }
  /// From the corner along its first wall and along its last, unit vectors.
  Point first() const { return first_; }
  Point last() const { return last_; }

  bool is_bounded() const { return is_bounded_; }

  /// May a leg lead to a place at `to` from the centre?
  bool may_lead(Point to) const { return beside(to, to) <= reach_ + kSlack * (std::abs(to.x) + std::abs(to.y)); }

  /// May a leg lead to anything between the rays through `right` and, less than half a turn to the left of it, `left`,
  /// that is at least `distance` away?
  bool may_lead(Point right, Point left, double distance) const {
    if (beside(right, left) == 0) return true;
    return beside(direction({}, right), direction({}, left)) * distance <= reach_ + kSlack * distance;
  }

 private:
  static constexpr double kSlack = 1e-12;

  static double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
  static Point direction(Point c, Point p) {
    const double x = p.x - c.x, y = p.y - c.y, length = std::hypot(x, y);
    return {x / length, y / length};
  }

  /// When both lie in the walls' angle, or both in its opposite, how far they are from the cones at least (from their
  /// lines), and all between that is not nearer; else 0.
  double beside(Point right, Point left) const {
    if (!is_bounded_) return 0;
    const auto [low, high] =
        std::minmax({cross(first_, right), cross(first_, left), cross(right, last_), cross(left, last_)});
    return low > 0 ? low : high < 0 ? -high : 0;
  }

  Point first_, last_;
  double rounding_ = 0;
  double reach_ = 0;
  bool is_bounded_ = false;
};

}  // namespace taut
