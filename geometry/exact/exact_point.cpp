#include <taut/geometry/exact/exact_point.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <taut/geometry/detail/written_integers.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool on_free_side(Point p, std::span<const Segment> edges) {
  return std::all_of(edges.begin(), edges.end(),
                     [p](const Segment& e) { return written::orientation(e.a, e.b, p) <= 0; });
}

Rational squared_distance(const ExactPoint& a, const ExactPoint& b) {
  const Rational dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

double step(double from, int ulps) {
  for (; ulps > 0; --ulps) from = std::nextafter(from, kInfinity);
  for (; ulps < 0; ++ulps) from = std::nextafter(from, -kInfinity);
  return from;
}

Integer power_of_ten(int exponent) { return power(10, static_cast<unsigned>(exponent)); }

Rational over_power(const Integer& digits, int places) {
  if (places <= 0) return Integer(digits * power_of_ten(-places));
  return fraction(digits, power_of_ten(places));
}

/// The nearest integer; halves go up.
Integer rounded(const Rational& q) { return floor_of_ratio(2 * numerator(q) + denominator(q), 2 * denominator(q)); }

/// Eight coordinates as integers over one denominator, so that there are no common divisors on the way.
struct Common {
  Integer ax, ay, bx, by, cx, cy, dx, dy;
  Integer denominator;
};

Common common(const Segment& s, const Segment& t) {
  const double values[] = {s.a.x, s.a.y, s.b.x, s.b.y, t.a.x, t.a.y, t.b.x, t.b.y};
  if (const int places = detail::common_places(values, 8); places >= 0) {
    const auto integer = [places](double v) { return Integer(detail::integer_over(v, places)); };
    return {integer(s.a.x), integer(s.a.y), integer(s.b.x), integer(s.b.y),      integer(t.a.x),
            integer(t.a.y), integer(t.b.x), integer(t.b.y), power_of_ten(places)};
  }
  std::array<Rational, 8> exact;
  Integer whole = 1;
  for (std::size_t i = 0; i < 8; ++i) {
    exact[i] = meaning(values[i]);
    whole = lcm(whole, denominator(exact[i]));
  }
  const auto integer = [&](std::size_t i) { return Integer(numerator(exact[i]) * (whole / denominator(exact[i]))); };
  return {integer(0), integer(1), integer(2), integer(3), integer(4), integer(5), integer(6), integer(7), whole};
}

/// Points around an exact point, the nearer ones first (as far as doubles can tell).
template <class Step>
std::vector<Point> surroundings(const ExactPoint& exact, Point centre, Step step_from) {
  const ExactPoint here(centre);
  const double off_x = to_double(Rational(exact.x - here.x)), off_y = to_double(Rational(exact.y - here.y));
  std::vector<std::pair<double, Point>> by_distance;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) {
      const Point p{step_from(centre.x, i), step_from(centre.y, j)};
      by_distance.emplace_back(std::hypot(p.x - centre.x - off_x, p.y - centre.y - off_y), p);
    }
  std::sort(by_distance.begin(), by_distance.end());
  std::vector<Point> points;
  points.reserve(by_distance.size());
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

Rational meaning(double v) {
  if (const auto d = written::decimal(v)) return over_power(integer(d->digits), d->places);
  return Rational(v);
}

DecimalUnit::DecimalUnit(double largest) {
  // floor(log10) may be one too low next to a power of ten: that leaves 14 digits there.
  places_ = largest > 0 ? 14 - static_cast<int>(std::floor(std::log10(largest))) : 14;
}

DecimalUnit::DecimalUnit(const Box& box)
    : DecimalUnit(std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)})) {}

double DecimalUnit::nearest(const Rational& q) const {
  const Integer digits =
      rounded(places_ >= 0 ? Rational(q * power_of_ten(places_)) : Rational(q / power_of_ten(-places_)));
  if (abs(digits) > 1'000'000'000'000'000) return nearest_double(q);
  return written::number(to_int64(digits), places_);
}

double DecimalUnit::step(double from, int steps) const {
  return steps == 0 ? from : nearest(meaning(from) + over_power(Integer(steps), places_));
}

ExactPoint line_crossing(const Segment& s, const Segment& t) {
  const Common n = common(s, t);
  const Integer sx = n.bx - n.ax, sy = n.by - n.ay, tx = n.dx - n.cx, ty = n.dy - n.cy;
  const Integer along = (n.cx - n.ax) * ty - (n.cy - n.ay) * tx, whole = sx * ty - sy * tx;
  const Integer denominator = whole * n.denominator;
  return {fraction(n.ax * whole + along * sx, denominator), fraction(n.ay * whole + along * sy, denominator)};
}

double nearest_double(const Rational& q) {
  const double toward_zero = to_double(q);
  const double away = std::nextafter(toward_zero, sgn(q) < 0 ? -kInfinity : kInfinity);
  const Rational below = abs(q - Rational(toward_zero)), above = abs(Rational(away) - q);
  return above < below ? away : toward_zero;
}

Point nearest_point(const ExactPoint& p) { return {nearest_double(p.x), nearest_double(p.y)}; }

std::optional<Point> exactly(const ExactPoint& p) {
  const Point q = nearest_point(p);
  return ExactPoint(q) == p ? std::optional(q) : std::nullopt;
}

double displacement(const ExactPoint& exact, Point rounded) {
  const double squared = to_double(squared_distance(exact, ExactPoint(rounded)));
  return squared == 0 ? 0 : std::nextafter(std::sqrt(std::nextafter(squared, kInfinity)), kInfinity);
}

namespace {

std::optional<Point> outward(const ExactPoint& exact, std::span<const Segment> edges, const DecimalUnit& unit) {
  const auto by_units = [&](double from, int steps) { return unit.step(from, steps); };
  for (const Point p : surroundings(exact, unit.nearest(exact), by_units))
    if (on_free_side(p, edges)) return p;
  const Point centre = nearest_point(exact);
  for (const Point p : surroundings(exact, centre, step))
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
  return std::nullopt;
}

}  // namespace

Point round_outward(const ExactPoint& exact, std::span<const Segment> edges, const DecimalUnit& unit) {
  if (const auto p = outward(exact, edges, unit)) return *p;
  const Point centre = nearest_point(exact);
  throw TooFine(
      fmt::format("two obstacles meet at ({}, {}) at an angle too sharp for double coordinates", centre.x, centre.y));
}

Point round_outward_or_nearest(const ExactPoint& exact, std::span<const Segment> edges, const DecimalUnit& unit) {
  if (const auto p = outward(exact, edges, unit)) return *p;
  return unit.nearest(exact);
}

}  // namespace taut
