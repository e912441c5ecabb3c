#include <taut/geometry/detail/segment_distance.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <gmpxx.h>
#include <mpfr.h>

#include <taut/geometry/predicates.h>

namespace taut::detail {

namespace {

constexpr double kEps = 0x1p-53;

/// The distance of p and the closed segment a b. Every difference, product and root adds at most kEps of its own size.
Interval enclose(Point p, Point a, Point b) {
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

Interval least(Interval a, Interval b) { return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)}; }

/// Calls f(p, a, b) with each end of one segment and the other: two disjoint segments are nearest at an end.
template <class F>
void for_each_end(const Segment& s, const Segment& t, F f) {
  f(s.a, t.a, t.b);
  f(t.a, s.a, s.b);
  if (s.a != s.b) f(s.b, t.a, t.b);
  if (t.a != t.b) f(t.b, s.a, s.b);
}

/// A double that knows whether any operation that led to it was rounded. Where coordinates are small multiples of a power
/// of two, as on every grid, none is.
struct Checked {
  double value = 0;
  bool exact = true;

  Checked(double v) : value(v) {}
  Checked(double v, bool e) : value(v), exact(e) {}

  friend Checked operator+(Checked a, Checked b) {
    const double sum = a.value + b.value, part = sum - a.value;
    return {sum, a.exact && b.exact && a.value - (sum - part) + (b.value - part) == 0};
  }
  friend Checked operator-(Checked a, Checked b) { return a + Checked(-b.value, b.exact); }
  friend Checked operator*(Checked a, Checked b) {
    const double product = a.value * b.value;
    // A product below 1e-200 may have lost bits that its error, too small to be a double, does not show.
    const bool shown = product == 0 ? a.value == 0 || b.value == 0 : std::abs(product) > 1e-200;
    return {product, a.exact && b.exact && shown && std::fma(a.value, b.value, -product) == 0};
  }
  friend bool operator<(Checked a, Checked b) { return a.value < b.value; }
};

bool exact(const Checked& value) { return value.exact; }
bool exact(const mpq_class&) { return true; }

/// A squared distance: over / under.
template <class Number>
struct Squared {
  Number over, under;
};

/// Nothing when a step was rounded.
template <class Number>
std::optional<Squared<Number>> squared(Point p, Point a, Point b) {
  const Number ux = Number(b.x) - Number(a.x), uy = Number(b.y) - Number(a.y);
  const Number vx = Number(p.x) - Number(a.x), vy = Number(p.y) - Number(a.y);
  const Number along = ux * vx + uy * vy, length = ux * ux + uy * uy;
  if (!exact(along) || !exact(length)) return std::nullopt;
  Squared<Number> result{vx * vx + vy * vy, Number(1)};
  if (!(along < length)) {
    const Number wx = vx - ux, wy = vy - uy;
    result.over = wx * wx + wy * wy;
  } else if (Number(0) < along) {
    const Number cross = ux * vy - uy * vx;
    result = {cross * cross, length};
  }
  if (!exact(result.over)) return std::nullopt;
  return result;
}

/// The sign of a - b; nothing when a step was rounded.
template <class Number>
std::optional<int> compare(const Squared<Number>& a, const Squared<Number>& b) {
  const Number left = a.over * b.under, right = b.over * a.under;
  if (!exact(left) || !exact(right)) return std::nullopt;
  return left < right ? -1 : right < left ? 1 : 0;
}

/// Precondition: s and t are disjoint, and their distance is within `enclosure`.
template <class Number>
std::optional<Squared<Number>> squared(const Segment& s, const Segment& t, const Interval& enclosure) {
  std::optional<Squared<Number>> best;
  bool known = true;
  for_each_end(s, t, [&](Point p, Point a, Point b) {
    if (!known || enclose(p, a, b).lo > enclosure.hi) return;
    const auto next = squared<Number>(p, a, b);
    const auto sign = !next ? std::nullopt : best ? compare(*next, *best) : -1;
    known = sign.has_value();
    if (known && *sign < 0) best = next;
  });
  return known ? best : std::nullopt;
}

template <class Number>
std::optional<int> compare(const Segment& s1, const Segment& t1, const Interval& first, const Segment& s2, const Segment& t2,
                           const Interval& second) {
  const auto a = squared<Number>(s1, t1, first);
  if (!a) return std::nullopt;
  const auto b = squared<Number>(s2, t2, second);
  return b ? compare(*a, *b) : std::nullopt;
}

double nearest_root(const Squared<mpq_class>& value) {
  const mpq_class quotient = value.over / value.under;
  mpfr_t root;
  mpfr_init2(root, 400);  // so far beyond a double that the second rounding cannot change the first
  mpfr_set_q(root, quotient.get_mpq_t(), MPFR_RNDN);
  mpfr_sqrt(root, root, MPFR_RNDN);
  const double result = mpfr_get_d(root, MPFR_RNDN);
  mpfr_clear(root);
  return result;
}

}  // namespace

Interval segment_distance_interval(const Segment& s, const Segment& t) {
  if (segments_meet(s, t)) return {0, 0};
  Interval result{HUGE_VAL, HUGE_VAL};
  for_each_end(s, t, [&](Point p, Point a, Point b) { result = least(result, enclose(p, a, b)); });
  return result;
}

int compare_segment_distances(const Segment& s1, const Segment& t1, const Segment& s2, const Segment& t2) {
  const Interval first = segment_distance_interval(s1, t1), second = segment_distance_interval(s2, t2);
  if (first.hi < second.lo) return -1;
  if (first.lo > second.hi) return 1;
  const bool first_meets = first.hi == 0, second_meets = second.hi == 0;
  if (first_meets || second_meets) return int(second_meets) - int(first_meets);
  if (const auto sign = compare<Checked>(s1, t1, first, s2, t2, second)) return *sign;
  return *compare<mpq_class>(s1, t1, first, s2, t2, second);
}

double segment_distance(const Segment& s, const Segment& t) {
  const Interval enclosure = segment_distance_interval(s, t);
  return enclosure.hi == 0 ? 0 : nearest_root(*squared<mpq_class>(s, t, enclosure));
}

}  // namespace taut::detail
