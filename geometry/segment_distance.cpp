#include <taut/geometry/segment_distance.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <gmpxx.h>
#include <mpfr.h>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

constexpr double kEps = 0x1p-53;

/// |a - b|; a single number when the difference is a double, as on grids.
Interval difference(double a, double b) {
  const double d = a - b, part = d - a;
  const double lost = (a - (d - part)) - (b + part);
  if (d != 0 && !(written::is_plain(a) && written::is_plain(b))) {
    const Interval x = written::enclosure(a), y = written::enclosure(b);
    const double low = std::min(std::abs(x.lo - y.hi), std::abs(x.hi - y.lo)),
                 high = std::max(std::abs(x.lo - y.hi), std::abs(x.hi - y.lo));
    return {low * (1 - 2 * kEps), high * (1 + 2 * kEps)};
  }
  return lost == 0 ? Interval{std::abs(d), std::abs(d)}
                   : Interval{std::abs(d) * (1 - 2 * kEps), std::abs(d) * (1 + 2 * kEps)};
}

bool between(double v, double a, double b) { return std::min(a, b) <= v && v <= std::max(a, b); }

/// The distance of p and the closed segment a b as doubles. Every difference, product and root adds at most kEps of its
/// own size.
Interval enclose_doubles(Point p, Point a, Point b) {
  const double ux = b.x - a.x, uy = b.y - a.y, length = std::hypot(ux, uy);
  const double ax = p.x - a.x, ay = p.y - a.y, to_a = std::hypot(ax, ay), to_b = std::hypot(p.x - b.x, p.y - b.y);
  const double end = std::min(to_a, to_b), reach = std::max(to_a, to_b);
  const double along = length > 0 ? (ux * ax + uy * ay) / length : 0;
  const double slack = 16 * kEps * reach + 1e-290;
  const bool beside = length > 0 && along > -slack && along < length + slack;
  if (!beside) return {end - 8 * kEps * end, end + 8 * kEps * end};
  const double off = std::abs(ux * ay - uy * ax) / length;
  const double error = 8 * kEps * ((std::abs(ux * ay) + std::abs(uy * ax)) / length + off) + 1e-290 / length;
  if (along > slack && along < length - slack) return {std::max(0.0, off - error), off + error};
  // The foot is so near an end that the line and the end are equally far, but for the slack.
  const double wide = error + slack + 8 * kEps * reach;
  return {std::max(0.0, std::min(off, end) - wide), std::min(off, end) + wide};
}

bool is_integer(double v) { return v == std::floor(v); }

/// The distance of what p and the closed segment a b mean.
Interval enclose(Point p, Point a, Point b) {
  if (a.x == b.x && between(p.y, a.y, b.y)) return difference(p.x, a.x);
  if (a.y == b.y && between(p.x, a.x, b.x)) return difference(p.y, a.y);
  const Interval distance = enclose_doubles(p, a, b);
  double moved = 0;  // a point is at most so far from what it means, and the distance changes no more
  for (const Point q : {p, a, b})
    if (!is_integer(q.x) || !is_integer(q.y)) moved = std::max({moved, std::abs(q.x), std::abs(q.y)});
  moved *= 6 * kEps;
  return {std::max(0.0, distance.lo - moved), distance.hi + moved};
}

Interval least(Interval a, Interval b) { return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)}; }

/// Calls f(p, a, b) with each end of one segment and the other: two disjoint segments are nearest at an end.
template <class F>
void for_each_end(const Segment& s, const Segment& t, F f) {
  f(s.a, t.a, t.b);
  f(t.a, s.a, s.b);
  if (s.a != s.b) f(s.b, t.a, t.b);
  if (t.a != t.b) f(t.b, s.a, s.b);
}

mpq_class exact_squared(Point p, Point a, Point b) {
  const ExactPoint from(a), to(b), at(p);
  const mpq_class ux = to.x - from.x, uy = to.y - from.y, vx = at.x - from.x, vy = at.y - from.y;
  const mpq_class along = ux * vx + uy * vy, length = ux * ux + uy * uy;
  if (along >= length) {
    const mpq_class wx = vx - ux, wy = vy - uy;
    return wx * wx + wy * wy;
  }
  if (along <= 0) return vx * vx + vy * vy;
  const mpq_class cross = ux * vy - uy * vx;
  return cross * cross / length;
}

mpq_class exact_squared(const Segment& s, const Segment& t) {
  if (written::segments_meet(s, t)) return 0;
  const double reach = segment_distance_interval(s, t).hi;
  mpq_class result = -1;
  for_each_end(s, t, [&](Point p, Point a, Point b) {
    if (enclose(p, a, b).lo > reach) return;
    const mpq_class squared = exact_squared(p, a, b);
    if (result < 0 || squared < result) result = squared;
  });
  return result;
}

double nearest_root(const mpq_class& value) {
  mpfr_t root;
  mpfr_init2(root, 400);  // so far beyond a double that the second rounding cannot change the first
  mpfr_set_q(root, value.get_mpq_t(), MPFR_RNDN);
  mpfr_sqrt(root, root, MPFR_RNDN);
  const double result = mpfr_get_d(root, MPFR_RNDN);
  mpfr_clear(root);
  return result;
}

}  // namespace

Interval segment_distance_interval(const Segment& s, const Segment& t) {
  if (written::segments_meet(s, t)) return {0, 0};
  Interval result{HUGE_VAL, HUGE_VAL};
  for_each_end(s, t, [&](Point p, Point a, Point b) { result = least(result, enclose(p, a, b)); });
  return result;
}

std::optional<int> compare(const Interval& a, const Interval& b) {
  if (a.hi < b.lo) return -1;
  if (a.lo > b.hi) return 1;
  if (a.lo == a.hi && b.lo == b.hi) return 0;
  return std::nullopt;
}

int compare_segment_distances(const Segment& s1, const Segment& t1, const Segment& s2, const Segment& t2) {
  if (const auto sign = compare(segment_distance_interval(s1, t1), segment_distance_interval(s2, t2))) return *sign;
  const int sign = cmp(exact_squared(s1, t1), exact_squared(s2, t2));
  return (sign > 0) - (sign < 0);
}

double segment_distance(const Segment& s, const Segment& t) { return nearest_root(exact_squared(s, t)); }

}  // namespace taut
