// What a number means, and exact signs of points that mean what was written.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <taut/geometry/interval.h>
#include <taut/geometry/point.h>

namespace taut::written {

/// People write decimals, and a double is only near to most of them: (0.8, 1.1) lies on the line from (0, 0.6) to
/// (4, 3.1), but their doubles do not. So a coordinate means
///  - the decimal, when the shortest decimal that reads back as the double has at most 15 significant digits (written),
///  - the double itself, else (computed).
/// Number by number: what one means does not depend on others. Different doubles mean different numbers in the same
/// order, so == and < of doubles are those of what they mean. All of World, FreeSpace and what is built on them asks
/// the predicates here; those of predicates.h take doubles as they are.

/// digits / 10^places. `digits` has at most 15 decimal digits and is no multiple of 10, unless it is 0 (0 / 10^0).
struct Decimal {
  std::int64_t digits = 0;
  int places = 0;

  friend bool operator==(const Decimal&, const Decimal&) = default;
};

/// The decimal that a written number means; nothing for a computed one. Precondition: finite.
std::optional<Decimal> decimal(double v);

/// The double that means digits / 10^places, to the nearest when there is none; exact for up to 15 digits within the
/// range of doubles.
double number(std::int64_t digits, int places);

/// Does `v` mean exactly the double that it is? So integers, halves and everything computed.
bool is_plain(double v);

/// The double nearest to what a + b (a - b, a / 2 + b / 2, n times a) mean together, and itself written where the
/// result has at most 15 digits: sum(0.7, 0.1) is 0.8.
double sum(double a, double b);
inline double difference(double a, double b) { return sum(a, -b); }
double middle(double a, double b);
double times(std::int64_t n, double a);
inline Point middle(const Segment& s) { return {middle(s.a.x, s.b.x), middle(s.a.y, s.b.y)}; }

/// Doubles that enclose what v means: itself for integers, else its neighbours. Cheap.
inline Interval enclosure(double v) {
  if (v == std::floor(v) && std::abs(v) <= 0x1p53) return {v, v};
  return {std::nextafter(v, -HUGE_VAL), std::nextafter(v, HUGE_VAL)};
}

/// The sign of what a + b - c means. Exact.
int compare_sum(double a, double b, double c);

namespace detail {

int exact_orientation(Point a, Point b, Point c);

/// The sign of orientation() where doubles are sure of it, else 0.
inline int quick_orientation(Point a, Point b, Point c) {
  const double acx = a.x - c.x, bcy = b.y - c.y, acy = a.y - c.y, bcx = b.x - c.x;
  const double det = acx * bcy - acy * bcx;
  // A coordinate is off by at most 2^-53 of itself, a difference by that of both; 9e-16 > 8 * 2^-53 covers all terms.
  const double reach = std::abs(acx) + std::abs(bcy) + std::abs(acy) + std::abs(bcx);
  const double bound = 9e-16 * reach * (reach + std::abs(c.x) + std::abs(c.y)) + 1e-290;
  return det > bound ? 1 : -det > bound ? -1 : 0;
}

}  // namespace detail

/// The sign of the signed area of the triangle a, b, c: +1 when c lies to the left of a -> b, 0 on the line, -1 to the
/// right. Exact for what the coordinates mean, of magnitude <= World::kLargest.
inline int orientation(Point a, Point b, Point c) {
  if (const int quick = detail::quick_orientation(a, b, c); quick != 0) return quick;
  // Three points in line along an axis never need big numbers.
  if ((a.x == c.x || b.y == c.y) && (a.y == c.y || b.x == c.x)) return 0;
  return detail::exact_orientation(a, b, c);
}

/// Does q lie on the closed segment a b? Exact.
inline bool on_segment(Point q, Point a, Point b) {
  const auto [x0, x1] = a.x < b.x ? std::pair(a.x, b.x) : std::pair(b.x, a.x);
  const auto [y0, y1] = a.y < b.y ? std::pair(a.y, b.y) : std::pair(b.y, a.y);
  return x0 <= q.x && q.x <= x1 && y0 <= q.y && q.y <= y1 && written::orientation(a, b, q) == 0;
}

/// Do the interiors of both segments meet in exactly one point that is an end of neither? Exact.
inline bool cross_properly(const Segment& s, const Segment& t) {
  const int o1 = written::orientation(s.a, s.b, t.a), o2 = written::orientation(s.a, s.b, t.b);
  if (o1 * o2 >= 0) return false;
  return written::orientation(t.a, t.b, s.a) * written::orientation(t.a, t.b, s.b) < 0;
}

/// Do the closed segments share a point? Exact.
bool segments_meet(const Segment& s, const Segment& t);

/// The sign of |p - a| - |p - b|. Exact.
int compare_distance(Point p, Point a, Point b);

/// +1 when d lies inside the circle through a, b, c (counter-clockwise), 0 on it, -1 outside. Exact.
int side_of_circle(Point a, Point b, Point c, Point d);

/// +1 counter-clockwise, -1 clockwise, 0 without area. Exact (at the lexicographically smallest vertex). Precondition:
/// simple.
int ring_orientation(const Ring& ring);

/// Where p lies with respect to a simple ring: +1 inside, 0 on it, -1 outside. Exact. O(n).
int side_of_ring(Point p, const Ring& ring);

}  // namespace taut::written
