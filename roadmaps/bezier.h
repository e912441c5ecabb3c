// The curves that Voronoi diagrams are made of.
#pragma once

#include <taut/geometry/point.h>

namespace taut {

/// A quadratic Bezier curve; a straight one has its control point in the middle.
struct Bezier {
  Point from;
  Point control;
  Point to;

  Point at(double t) const;
  Bezier part(double t0, double t1) const;
  double length() const;  ///< relative error about 1e-13
};

/// The point of s nearest to p, rounded. s may be a point.
Point foot_on(const Segment& s, Point p);

}  // namespace taut
