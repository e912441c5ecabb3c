// A leg and the walls near it in doubles: what they can tell for sure, and what has to be asked exactly.
#pragma once

#include <algorithm>
#include <cmath>

#include <taut/geometry/point.h>

namespace taut {

/// A leg of the disc's centre as doubles: from a point, along a unit vector.
struct PlainLeg {
  Point from, along;
  double length = 0;

  /// +1: no point of the wall is as near as `far`; -1: one is nearer than `near`; 0: neither is known. As doubles go:
  /// who calls leaves room for what they are off. Precondition: 0 < far, near <= far; near may be below 0.
  int clears(Point w, Point v, double near, double far) const {
    const Place p = place(w), q = place(v);
    if ((p.y > far && q.y > far) || (p.y < -far && q.y < -far)) return 1;
    if ((p.x < -far && q.x < -far) || (p.x > length + far && q.x > length + far)) return 1;
    const double square = crosses(p, q) ? 0 : squared_distance(p, q);
    if (square > far * far) return 1;
    return near > 0 && square < near * near ? -1 : 0;
  }

 private:
  /// Along the leg, and to its left.
  struct Place {
    double x, y;
  };

  Place place(Point p) const {
    const double x = p.x - from.x, y = p.y - from.y;
    return {along.x * x + along.y * y, along.x * y - along.y * x};
  }
  bool crosses(Place p, Place q) const {
    if (!(p.y * q.y < 0)) return false;
    const double x = p.x - p.y * (q.x - p.x) / (q.y - p.y);
    return x >= 0 && x <= length;
  }
  double squared_distance(Place p, Place q) const {
    return std::min(std::min(beside_leg(p), beside_leg(q)), std::min(beside(0, p, q), beside(length, p, q)));
  }
  /// Of a place from the leg.
  double beside_leg(Place p) const {
    const double x = p.x < 0 ? p.x : std::max(0.0, p.x - length);
    return x * x + p.y * p.y;
  }
  /// Of the leg's point at x from a segment's inside; what is nearest to an end of that is no concern of this.
  static double beside(double x, Place p, Place q) {
    const Place f{q.x - p.x, q.y - p.y}, t{x - p.x, -p.y};
    const double along = f.x * t.x + f.y * t.y, all = f.x * f.x + f.y * f.y;
    if (along <= 0 || along >= all) return std::min(t.x * t.x + t.y * t.y, square(x - q.x) + square(q.y));
    return square(f.x * t.y - f.y * t.x) / all;
  }
  static double square(double v) { return v * v; }
};

}  // namespace taut
