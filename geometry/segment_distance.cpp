#include <taut/geometry/segment_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <taut/geometry/exact/as_double.h>
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
    const double least = x.lo - y.hi, most = x.hi - y.lo;
    const double low = least < 0 && most > 0 ? 0 : std::min(std::abs(least), std::abs(most)),
                 high = std::max(std::abs(least), std::abs(most));
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

/// One that means itself: beyond 2^53 every double is whole, but most mean a decimal beside it.
bool is_integer(double v) { return std::abs(v) <= 0x1p53 && v == std::floor(v); }

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

__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): pedantic compilers take no other

/// Small multiples of 1/64, which mean themselves: what most worlds consist of. A ratio of squares of their differences
/// fits 128 bits, and so do two of them multiplied crosswise.
constexpr double kGrain = 64;
constexpr double kMost = 1 << 19;  // grains

using Grains = std::array<std::int64_t, 2>;

std::optional<Grains> grains(Point p) {
  const double x = p.x * kGrain, y = p.y * kGrain;
  if (!(std::abs(x) < kMost && std::abs(y) < kMost)) return std::nullopt;
  const auto i = static_cast<std::int64_t>(x), j = static_cast<std::int64_t>(y);
  if (static_cast<double>(i) != x || static_cast<double>(j) != y) return std::nullopt;
  return Grains{i, j};
}

/// A squared distance in grains, below 2^82 over below 2^42.
struct Ratio {
  Int128 above;
  std::int64_t below;

  friend int compare(const Ratio& a, const Ratio& b) {
    const Int128 left = a.above * b.below, right = b.above * a.below;
    return (left > right) - (left < right);
  }
};

Ratio squared(Grains p, Grains a, Grains b) {
  const std::int64_t ux = b[0] - a[0], uy = b[1] - a[1], vx = p[0] - a[0], vy = p[1] - a[1];
  const std::int64_t along = ux * vx + uy * vy, length = ux * ux + uy * uy;
  if (along >= length) return {Int128{(vx - ux) * (vx - ux) + (vy - uy) * (vy - uy)}, 1};
  if (along <= 0) return {Int128{vx * vx + vy * vy}, 1};
  const Int128 cross = ux * vy - uy * vx;
  return {cross * cross, length};
}

/// Of segments that do not meet, or of which one is a point; nothing where they are not so simple.
std::optional<Ratio> simple_squared(const Segment& s, const Segment& t) {
  const auto sa = grains(s.a), sb = grains(s.b), ta = grains(t.a), tb = grains(t.b);
  if (!sa || !sb || !ta || !tb) return std::nullopt;
  Ratio least = squared(*sa, *ta, *tb);
  const auto take = [&](const Ratio& r) {
    if (compare(r, least) < 0) least = r;
  };
  take(squared(*ta, *sa, *sb));
  if (s.a != s.b) take(squared(*sb, *ta, *tb));
  if (t.a != t.b) take(squared(*tb, *sa, *sb));
  const bool may_cross = s.a != s.b && t.a != t.b;
  return may_cross && written::segments_meet(s, t) ? Ratio{0, 1} : least;
}

/// The nearest double to its root in units; nothing where 64 bits do not tell.
std::optional<double> quick_root(const Ratio& r) {
  constexpr long double kSlack = 4 * std::numeric_limits<long double>::epsilon();
  const long double root = std::sqrt(static_cast<long double>(r.above) / static_cast<long double>(r.below));
  const auto low = static_cast<double>(root * (1 - kSlack)), high = static_cast<double>(root * (1 + kSlack));
  if (low != high) return std::nullopt;
  return low / kGrain;
}

Rational exact_squared(Point p, Point a, Point b) {
  const ExactPoint from(a), to(b), at(p);
  const Rational ux = to.x - from.x, uy = to.y - from.y, vx = at.x - from.x, vy = at.y - from.y;
  const Rational along = ux * vx + uy * vy, length = ux * ux + uy * uy;
  if (along >= length) {
    const Rational wx = vx - ux, wy = vy - uy;
    return wx * wx + wy * wy;
  }
  if (along <= 0) return vx * vx + vy * vy;
  const Rational cross = ux * vy - uy * vx;
  return cross * cross / length;
}

Rational exact_squared(const Segment& s, const Segment& t) {
  if (written::segments_meet(s, t)) return 0;
  const double reach = segment_distance_interval(s, t).hi;
  Rational result = -1;
  for_each_end(s, t, [&](Point p, Point a, Point b) {
    if (enclose(p, a, b).lo > reach) return;
    const Rational squared = exact_squared(p, a, b);
    if (result < 0 || squared < result) result = squared;
  });
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
  const auto first = simple_squared(s1, t1);
  if (const auto second = first ? simple_squared(s2, t2) : std::nullopt) return compare(*first, *second);
  if (const auto sign = compare(segment_distance_interval(s1, t1), segment_distance_interval(s2, t2))) return *sign;
  const int sign = cmp(exact_squared(s1, t1), exact_squared(s2, t2));
  return (sign > 0) - (sign < 0);
}

double segment_distance(const Segment& s, const Segment& t) {
  if (const auto simple = simple_squared(s, t))
    if (const auto root = quick_root(*simple)) return *root;
  return root_as_double(exact_squared(s, t), Toward::nearest);
}

}  // namespace taut
