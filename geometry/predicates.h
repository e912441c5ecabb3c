// Exact signs. Each first tries plain doubles with a proven error bound and falls back to CGAL's exact kernel.
#pragma once

#include <cmath>
#include <cstdint>

#include <taut/geometry/point.h>

namespace taut {

namespace detail {
int exact_orientation(Point a, Point b, Point c);
}

/// The sign of the signed area of the triangle a, b, c: +1 when c lies to the left of a -> b, 0 on the line, -1 to the
/// right. Exact for all finite coordinates of magnitude <= World::kLargest. Filter: Shewchuk, "Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates" (1997), section 4.3.
inline int orientation(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  // (3 + 16 eps) eps with eps = 2^-53; the second term covers underflow.
  const double bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right)) + 1e-290;
  if (det > bound) return 1;
  if (-det > bound) return -1;
  return detail::exact_orientation(a, b, c);
}

/// Does q lie on the closed segment a b? Exact.
inline bool on_segment(Point q, Point a, Point b) {
  const auto [x0, x1] = a.x < b.x ? std::pair(a.x, b.x) : std::pair(b.x, a.x);
  const auto [y0, y1] = a.y < b.y ? std::pair(a.y, b.y) : std::pair(b.y, a.y);
  return x0 <= q.x && q.x <= x1 && y0 <= q.y && q.y <= y1 && orientation(a, b, q) == 0;
}

/// Do the interiors of both segments meet in exactly one point that is an end of neither? Exact.
inline bool cross_properly(const Segment& s, const Segment& t) {
  const int o1 = orientation(s.a, s.b, t.a), o2 = orientation(s.a, s.b, t.b);
  if (o1 * o2 >= 0) return false;
  return orientation(t.a, t.b, s.a) * orientation(t.a, t.b, s.b) < 0;
}

/// Do the closed segments share a point? Exact.
bool segments_meet(const Segment& s, const Segment& t);

/// The sign of |p - a| - |p - b|. Exact.
int compare_distance(Point p, Point a, Point b);

/// Twice the signed area of a ring, to within rounding; its sign is exact through ring_orientation.
double ring_area(const Ring& ring);

/// +1 counter-clockwise, -1 clockwise, 0 without area. Exact (at the lexicographically smallest vertex). Precondition:
/// simple.
int ring_orientation(const Ring& ring);

/// Where p lies with respect to a simple ring: +1 inside, 0 on it, -1 outside. Exact. O(n).
int side_of_ring(Point p, const Ring& ring);

}  // namespace taut
