#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <atomic>
#include <initializer_list>

#include <taut/geometry/detail/written_integers.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/predicates.h>
#include <taut/geometry/written.h>

namespace taut {

namespace detail {

int common_places(const double* values, std::size_t count) {
  int places = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isnan(integer_over(values[i], places))) continue;
    const auto d = written::decimal(values[i]);
    if (!d || d->places > 22) return -1;
    places = std::max(places, d->places);
  }
  for (std::size_t i = 0; i < count; ++i)
    if (std::isnan(integer_over(values[i], places))) return -1;
  return places;
}

namespace {

bool try_integers(const double* values, std::size_t count, double* integers, int places) {
  for (std::size_t i = 0; i < count; ++i)
    if (std::isnan(integers[i] = integer_over(values[i], places))) return false;
  return true;
}

/// Only ever saves time: any power of ten over which all numbers are integers gives the same signs.
std::atomic<int> last_places{0};

}  // namespace

bool to_integers(const double* values, std::size_t count, double* integers) {
  const int last = last_places.load(std::memory_order_relaxed);
  if (try_integers(values, count, integers, last)) return true;
  const int places = common_places(values, count);
  if (places < 0) return false;
  last_places.store(places, std::memory_order_relaxed);
  return try_integers(values, count, integers, places);
}

}  // namespace detail

namespace written {

namespace {

__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): pedantic compilers take no other

using taut::meaning;

Wide wide(double v) { return static_cast<std::int64_t>(v); }
int sign(Wide v) { return (v > 0) - (v < 0); }

bool all_plain(std::initializer_list<Point> points) {
  return std::all_of(points.begin(), points.end(), [](Point p) { return is_plain(p.x) && is_plain(p.y); });
}

Rational squared_distance(Point p, Point q) {
  const Rational dx = meaning(p.x) - meaning(q.x), dy = meaning(p.y) - meaning(q.y);
  return dx * dx + dy * dy;
}

/// Positive when the origin is inside the circle through a, b, c.
template <class Number>
Number circle_determinant(const Number& ax, const Number& ay, const Number& bx, const Number& by, const Number& cx,
                          const Number& cy) {
  return (ax * ax + ay * ay) * (bx * cy - by * cx) - (bx * bx + by * by) * (ax * cy - ay * cx) +
         (cx * cx + cy * cy) * (ax * by - ay * bx);
}

int circle_in_integers(const double* n) {
  double v[6], largest = 0;
  for (int i = 0; i < 6; ++i) largest = std::max(largest, std::abs(v[i] = n[i] - n[6 + i % 2]));
  if (largest < 0x1p29)
    return sign(circle_determinant(wide(v[0]), wide(v[1]), wide(v[2]), wide(v[3]), wide(v[4]), wide(v[5])));
  Integer z[6];
  for (int i = 0; i < 6; ++i) z[i] = Integer(v[i]);
  return sgn(circle_determinant(z[0], z[1], z[2], z[3], z[4], z[5]));
}

int circle_in_doubles(Point a, Point b, Point c, Point d) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto cgal = [](Point p) { return Kernel::Point_2(p.x, p.y); };
  return static_cast<int>(CGAL::side_of_oriented_circle(cgal(a), cgal(b), cgal(c), cgal(d)));
}

int circle_in_rationals(Point a, Point b, Point c, Point d) {
  const Rational x = meaning(d.x), y = meaning(d.y);
  const Rational ax = meaning(a.x) - x, ay = meaning(a.y) - y, bx = meaning(b.x) - x, by = meaning(b.y) - y,
                 cx = meaning(c.x) - x, cy = meaning(c.y) - y;
  return sgn(circle_determinant(ax, ay, bx, by, cx, cy));
}

}  // namespace

namespace detail {

int exact_orientation(Point a, Point b, Point c) {
  // Common on grids: an axis-parallel line, where the sign of one product decides.
  if (a.x == b.x) return a.y == b.y ? 0 : (a.x == c.x ? 0 : ((a.x < c.x) == (a.y > b.y) ? 1 : -1));
  if (a.y == b.y) return a.y == c.y ? 0 : ((a.y < c.y) == (a.x < b.x) ? 1 : -1);
  if (a == c || b == c) return 0;
  const double values[] = {a.x, a.y, b.x, b.y, c.x, c.y};
  double n[6];
  if (taut::detail::to_integers(values, 6, n))
    return sign(wide(n[0] - n[4]) * wide(n[3] - n[5]) - wide(n[1] - n[5]) * wide(n[2] - n[4]));
  if (all_plain({a, b, c})) return taut::detail::exact_orientation(a, b, c);
  const Rational x = meaning(c.x), y = meaning(c.y);
  return sgn(Rational((meaning(a.x) - x) * (meaning(b.y) - y) - (meaning(a.y) - y) * (meaning(b.x) - x)));
}

}  // namespace detail

int compare_distance(Point p, Point a, Point b) {
  const double values[] = {p.x, p.y, a.x, a.y, b.x, b.y};
  double n[6];
  if (taut::detail::to_integers(values, 6, n)) {
    const Wide ax = wide(n[2] - n[0]), ay = wide(n[3] - n[1]), bx = wide(n[4] - n[0]), by = wide(n[5] - n[1]);
    return sign(ax * ax + ay * ay - bx * bx - by * by);
  }
  if (all_plain({p, a, b})) return taut::compare_distance(p, a, b);
  const int order = cmp(squared_distance(p, a), squared_distance(p, b));
  return (order > 0) - (order < 0);
}

int side_of_circle(Point a, Point b, Point c, Point d) {
  const double v[] = {a.x - d.x, a.y - d.y, b.x - d.x, b.y - d.y, c.x - d.x, c.y - d.y};
  double reach = 0;
  for (const double difference : v) reach = std::max(reach, std::abs(difference));
  // Twelve products of four differences, each off by 2^-52 (reach + size) before rounding.
  const double det = circle_determinant(v[0], v[1], v[2], v[3], v[4], v[5]);
  const double size = reach + std::max(std::abs(d.x), std::abs(d.y));
  if (const double bound = 400 * 0x1p-53 * size * reach * reach * reach + 1e-280; std::abs(det) > bound)
    return det > 0 ? 1 : -1;
  const double values[] = {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
  double n[8];
  if (taut::detail::to_integers(values, 8, n)) return circle_in_integers(n);
  if (all_plain({a, b, c, d})) return circle_in_doubles(a, b, c, d);
  return circle_in_rationals(a, b, c, d);
}

}  // namespace written

}  // namespace taut
