// Signs and constructions on points that are rational.
#pragma once

#include <optional>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/written.h>

namespace taut::bug::detail {

using taut::ExactPoint;

/// A point that is often, not always, a pair of doubles: predicates are quick when it is.
struct Spot {
  ExactPoint exact;
  std::optional<Point> doubles;

  explicit Spot(Point p) : exact(p), doubles(p) {}
  explicit Spot(const ExactPoint& p);
};

/// The sign of the area of a, b, c, as of three Points. Exact.
int orientation(const Spot& a, const Spot& b, Point c);
int orientation(const Spot& a, Point b, Point c);
int orientation(Point a, Point b, const Spot& c);

/// Are a and b on the same ray out of v? Precondition: all three are in line, neither is v.
bool same_way(const ExactPoint& v, const ExactPoint& a, const ExactPoint& b);

Rational squared_distance(const ExactPoint& a, const ExactPoint& b);

/// Where the line through p and q meets the one through a and b. Precondition: they are not parallel.
ExactPoint crossing(const Spot& p, const Spot& q, Point a, Point b);

/// The point of the closed segment a b nearest to p.
ExactPoint nearest_on(Point a, Point b, const ExactPoint& p);

/// The sign of sqrt(a) + sqrt(b) - sqrt(c) - sqrt(d). Exact. Precondition: none is negative.
int compare_roots(const Rational& a, const Rational& b, const Rational& c, const Rational& d);

}  // namespace taut::bug::detail
