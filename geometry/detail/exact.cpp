#include <taut/geometry/detail/exact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/predicates.h>

namespace taut::detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool on_free_side(Point p, std::span<const Segment> edges) {
  return std::all_of(edges.begin(), edges.end(), [p](const Segment& e) { return orientation(e.a, e.b, p) <= 0; });
}

mpq_class squared_distance(const ExactPoint& a, Point b) {
  const mpq_class dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

double step(double from, int ulps) {
  for (; ulps > 0; --ulps) from = std::nextafter(from, kInfinity);
  for (; ulps < 0; ++ulps) from = std::nextafter(from, -kInfinity);
  return from;
}

std::vector<Point> surroundings(const ExactPoint& exact) {
  const Point centre = nearest_point(exact);
  std::vector<Point> points;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) points.push_back({step(centre.x, i), step(centre.y, j)});
  std::sort(points.begin(), points.end(), [&](Point a, Point b) {
    const mpq_class da = squared_distance(exact, a), db = squared_distance(exact, b);
    return da != db ? da < db : a < b;
  });
  return points;
}

/// The middle of the wedge to the right of all edges.
Point free_direction(std::span<const Segment> edges) {
  Point sum;
  for (const Segment& e : edges) {
    const double dx = e.b.x - e.a.x, dy = e.b.y - e.a.y, length = std::hypot(dx, dy);
    sum.x += dy / length;
    sum.y -= dx / length;
  }
  const double length = std::hypot(sum.x, sum.y);
  return length > 0 ? Point{sum.x / length, sum.y / length} : Point{};
}

}  // namespace

ExactPoint line_crossing(const Segment& s, const Segment& t) {
  const ExactPoint a(s.a), b(s.b), c(t.a), d(t.b);
  const mpq_class sx = b.x - a.x, sy = b.y - a.y, tx = d.x - c.x, ty = d.y - c.y;
  const mpq_class along = ((c.x - a.x) * ty - (c.y - a.y) * tx) / (sx * ty - sy * tx);
  return {a.x + along * sx, a.y + along * sy};
}

double nearest_double(const mpq_class& q) {
  const double toward_zero = q.get_d();
  const double away = std::nextafter(toward_zero, sgn(q) < 0 ? -kInfinity : kInfinity);
  const mpq_class below = abs(q - mpq_class(toward_zero)), above = abs(mpq_class(away) - q);
  return above < below ? away : toward_zero;
}

Point nearest_point(const ExactPoint& p) { return {nearest_double(p.x), nearest_double(p.y)}; }

double displacement(const ExactPoint& exact, Point rounded) {
  const double squared = squared_distance(exact, rounded).get_d();
  return squared == 0 ? 0 : std::nextafter(std::sqrt(std::nextafter(squared, kInfinity)), kInfinity);
}

Point round_outward(const ExactPoint& exact, std::span<const Segment> edges) {
  for (const Point p : surroundings(exact))
    if (on_free_side(p, edges)) return p;
  const Point centre = nearest_point(exact), direction = free_direction(edges);
  double limit = kInfinity;
  for (const Segment& e : edges) limit = std::min(limit, std::hypot(e.b.x - e.a.x, e.b.y - e.a.y) / 1000);
  const double ulp = step(std::max(std::abs(centre.x), std::abs(centre.y)), 1) - std::max(std::abs(centre.x), std::abs(centre.y));
  for (double reach = 3 * ulp; reach < limit; reach *= 1.5) {
    const Point p{centre.x + direction.x * reach, centre.y + direction.y * reach};
    if (on_free_side(p, edges)) return p;
  }
  throw InputError({}, 0, "two obstacles meet at (" + std::to_string(centre.x) + ", " + std::to_string(centre.y) +
                              ") at an angle too sharp for double coordinates");
}

}  // namespace taut::detail
