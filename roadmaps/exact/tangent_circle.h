// Points of one circle in exact order around it, and which walls cut its arcs.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <taut/roadmaps/exact/tangent_line.h>

namespace taut {

/// A direction from a centre, (a + b sqrt(R)) in each coordinate, up to a positive factor.
struct SurdDirection {
  Rational ax, ay, bx, by, R;
};

/// Where a tangent touches a circle, as a direction from its centre. `side` is the side that the tangent has the centre
/// on when it leads away, to `other`.
struct TangentPoint {
  TangentPoint() = default;
  TangentPoint(const TangentEnd& here, const TangentEnd& there, double r);
  /// With what its unit direction is known to be.
  TangentPoint(const TangentEnd& this_end, const TangentEnd& there, double radius, const Interval& dx,
               const Interval& dy)
      : here(this_end), other(there), r(radius), x(dx), y(dy) {}

  SurdDirection exact() const;

  TangentEnd here, other;
  double r = 0;
  Interval x, y;  ///< of the unit direction
};

/// The sign of a x b, of a b, and with rational directions to the point `to` as seen from the centre. Exact.
int cross_sign(const TangentPoint& a, const TangentPoint& b);
int dot_sign(const TangentPoint& a, const TangentPoint& b);
int cross_sign(const TangentPoint& a, const SurdDirection& b);
int cross_sign(const TangentPoint& a, const Rational& x, const Rational& y);
/// A rational direction v, enclosed first.
struct PlainDirection {
  PlainDirection() = default;
  PlainDirection(Point from, Point to, int quarters);

  Point from, to;    ///< v leads from one to the other, then
  int quarters = 0;  ///< is turned left by so many right angles
  Interval x, y;     ///< enclose v
};
int cross_sign(const TangentPoint& a, const PlainDirection& v);

/// The angle from a to b, both on one circle and at most 180 degrees apart.
Interval angle_between(const TangentPoint& a, const TangentPoint& b);

/// A wall that comes nearer than r to some point of a circle of radius r that it does not end in the centre of: the
/// direction to its nearest point. The points it forbids are an open arc around that direction. Nothing when it is 2r
/// away or farther. Exact.
std::optional<PlainDirection> direction_forbidden(Point centre, double r, Point w, Point v);

}  // namespace taut
