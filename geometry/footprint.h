// What moves: the shape of the robot around its reference point.
#pragma once

#include <taut/geometry/point.h>

namespace taut {

/// A robot that translates: a point, a disc around its centre, or a convex polygon around its reference point.
class Footprint {
 public:
  enum class Kind { point, disc, polygon };

  static Footprint point() { return {}; }
  /// A disc of radius r > 0. The free space is built for the circumscribed regular polygon with kDiscSides sides:
  /// obstacles never shrink, and grow by at most kDiscExcess * r too much.
  static Footprint disc(double r);
  /// The axis-parallel square of half side r > 0, reference point in the middle.
  static Footprint square(double r);
  /// A convex counter-clockwise polygon that contains the origin (its reference point) in its interior.
  /// Throws InputError when it is not.
  static Footprint polygon(Ring ring);

  static constexpr int kDiscSides = 64;
  static constexpr double kDiscExcess = 0.00121;  // 1 / cos(pi / 64) - 1, rounded up

  Kind kind() const { return kind_; }
  double radius() const { return radius_; }   ///< disc radius or half side; 0 for a point or a general polygon
  const Ring& ring() const { return ring_; }  ///< the polygon the free space is built for; empty for a point

 private:
  Kind kind_ = Kind::point;
  double radius_ = 0;
  Ring ring_;
};

}  // namespace taut
