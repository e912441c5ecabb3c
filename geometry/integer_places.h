// Points of a world, and of queries in it, as integers.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/point.h>

namespace taut {

/// Multiples of 1 / per_unit counted from a corner, below 2^29: sides of lines are int64 then.
///
/// The unit is the finest decimal one that leaves all the world's points below that bound, else a binary one: places
/// that people ask about lie on it, too.
class IntegerPlaces {
 public:
  using Place = std::array<std::int32_t, 2>;

  static constexpr std::int64_t kLimit = std::int64_t{1} << 29;

  /// Nothing where the points lie on no such lattice.
  static std::optional<IntegerPlaces> of(std::span<const Point> points);

  double per_unit() const { return per_unit_; }

  /// What the point means (written.h); false when that is no multiple, or beyond the box of the points.
  bool find(Point p, Place& place) const { return find(p.x, 0, place) && find(p.y, 1, place); }

  /// Of a -> b, to the left of which c lies: +1.
  static int side(Place a, Place b, Place c) {
    const std::int64_t turn = cross(difference(b, a), difference(c, a));
    return (turn > 0) - (turn < 0);
  }
  static Place difference(Place a, Place b) { return {a[0] - b[0], a[1] - b[1]}; }
  static std::int64_t cross(Place a, Place b) { return std::int64_t{a[0]} * b[1] - std::int64_t{a[1]} * b[0]; }
  static double distance(Place a, Place b) {
    const double x = a[0] - b[0], y = a[1] - b[1];
    return std::sqrt(x * x + y * y);
  }

 private:
  static std::optional<IntegerPlaces> of(std::span<const Point> points, double per_unit);
  /// i / per_unit is rounded to the nearest double, which means that quotient: with 15 digits at most it is written.
  bool find(double v, int axis, Place& place) const {
    const double scaled = v * per_unit_;
    if (!(std::abs(scaled) < 1e15)) return false;
    const auto i = static_cast<std::int64_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
    if (static_cast<double>(i) / per_unit_ != v) return false;
    const std::int64_t from_corner = i - corner_[axis];
    if (from_corner < 0 || from_corner > extent_[axis]) return false;
    place[axis] = static_cast<std::int32_t>(from_corner);
    return true;
  }

  double per_unit_ = 1;
  std::array<std::int64_t, 2> corner_{}, extent_{};
};

}  // namespace taut
