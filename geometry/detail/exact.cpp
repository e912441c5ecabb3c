#include <taut/geometry/detail/exact.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

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

/// How many binary places after the point the coordinates have at most; negative when they all end in zeros.
int common_scale(std::initializer_list<Point> points) {
  int scale = std::numeric_limits<int>::min();
  for (const Point p : points)
    for (const double c : {p.x, p.y}) {
      if (c == 0) continue;
      int exponent = 0;
      std::frexp(c, &exponent);
      scale = std::max(scale, 53 - exponent);
    }
  return scale == std::numeric_limits<int>::min() ? 0 : scale;
}

/// c * 2^scale, an integer.
mpz_class scaled(double c, int scale) {
  int exponent = 0;
  mpz_class result(std::ldexp(std::frexp(c, &exponent), 53));
  if (c != 0) result <<= static_cast<mp_bitcnt_t>(exponent - 53 + scale);
  return result;
}

/// numerator / denominator / 2^scale in lowest terms.
mpq_class ratio(mpz_class numerator, mpz_class denominator, int scale) {
  (scale >= 0 ? denominator : numerator) <<= static_cast<mp_bitcnt_t>(std::abs(scale));
  mpq_class result(numerator, denominator);
  result.canonicalize();
  return result;
}

/// Doubles around an exact point, the nearer ones first (as far as doubles can tell).
std::vector<Point> surroundings(const ExactPoint& exact, Point centre) {
  const double off_x = mpq_class(exact.x - centre.x).get_d(), off_y = mpq_class(exact.y - centre.y).get_d();
  std::vector<std::pair<double, Point>> by_distance;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) {
      const Point p{step(centre.x, i), step(centre.y, j)};
      by_distance.emplace_back(std::hypot(p.x - centre.x - off_x, p.y - centre.y - off_y), p);
    }
  std::sort(by_distance.begin(), by_distance.end());
  std::vector<Point> points;
  for (const auto& [distance, p] : by_distance) points.push_back(p);
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
  // Doubles are integers over a power of two; as such they need no common divisors on the way.
  const int scale = common_scale({s.a, s.b, t.a, t.b});
  const mpz_class ax = scaled(s.a.x, scale), ay = scaled(s.a.y, scale), sx = scaled(s.b.x, scale) - ax,
                  sy = scaled(s.b.y, scale) - ay;
  const mpz_class cx = scaled(t.a.x, scale), cy = scaled(t.a.y, scale), tx = scaled(t.b.x, scale) - cx,
                  ty = scaled(t.b.y, scale) - cy;
  const mpz_class along = (cx - ax) * ty - (cy - ay) * tx, whole = sx * ty - sy * tx;
  return {ratio(ax * whole + along * sx, whole, scale), ratio(ay * whole + along * sy, whole, scale)};
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
  const Point centre = nearest_point(exact);
  for (const Point p : surroundings(exact, centre))
    if (on_free_side(p, edges)) return p;
  const Point direction = free_direction(edges);
  double limit = kInfinity;
  for (const Segment& e : edges) limit = std::min(limit, std::hypot(e.b.x - e.a.x, e.b.y - e.a.y) / 1000);
  const double ulp =
      step(std::max(std::abs(centre.x), std::abs(centre.y)), 1) - std::max(std::abs(centre.x), std::abs(centre.y));
  for (double reach = 3 * ulp; reach < limit; reach *= 1.5) {
    const Point p{centre.x + direction.x * reach, centre.y + direction.y * reach};
    if (on_free_side(p, edges)) return p;
  }
  throw TooFine(
      fmt::format("two obstacles meet at ({}, {}) at an angle too sharp for double coordinates", centre.x, centre.y));
}

}  // namespace taut::detail
