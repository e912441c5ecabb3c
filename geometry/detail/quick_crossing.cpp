#include <taut/geometry/detail/quick_crossing.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/detail/root.h>

namespace taut::detail {

namespace {

// Bounds for double-double operations: Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building
// blocks of double-word arithmetic" (2017), each rounded up generously.
constexpr double kProduct = 0x1p-100, kQuotient = 0x1p-96, kSum = 0x1p-102;

Pair add(Pair a, Pair b) {
  const Pair high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
  const Pair middle = two_sum(high.high, high.low + low.high);
  return two_sum(middle.high, middle.low + low.low);
}
Pair negative(Pair a) { return {-a.high, -a.low}; }
Pair times(Pair a, Pair b) {
  const Pair p = two_product(a.high, b.high);
  return two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
Pair over(Pair a, Pair b) {
  const double q1 = a.high / b.high;
  const Pair rest = add(a, negative(times({q1, 0}, b)));
  const double q2 = rest.high / b.high;
  const double q3 = add(rest, negative(times({q2, 0}, b))).high / b.high;
  return add(two_sum(q1, q2), {q3, 0});
}

/// A value and how far off it may be.
struct Bounded {
  Pair value;
  double error = 0;
};

Bounded cross(Pair ax, Pair ay, Pair bx, Pair by) {
  const Pair p = times(ax, by), q = times(ay, bx);
  return {add(p, negative(q)), 2 * kProduct * (std::abs(p.high) + std::abs(q.high))};
}

/// from + along * step, where `relative` bounds the relative error of `along`.
Bounded walk(double from, Pair along, double relative, Pair step) {
  const Pair way = times(along, step);
  const Pair value = add({from, 0}, way);
  return {value, 1.001 * (std::abs(way.high) * (relative + kProduct) + std::abs(value.high) * kSum)};
}

/// Is the value surely neither a double nor half way between two, so that its high part is its rounding?
bool is_rounded(const Bounded& v) {
  const double high = std::abs(v.value.high), low = std::abs(v.value.low);
  const double half = (high - std::nextafter(high, 0)) / 2;
  return low > v.error && low + v.error < half;
}

}  // namespace

std::optional<RoundedCrossing> quick_crossing(const Segment& s, const Segment& t) {
  for (const Point p : {s.a, s.b, t.a, t.b})
    if (std::max(std::abs(p.x), std::abs(p.y)) > 0x1p300) return std::nullopt;
  const Pair sx = two_sum(s.b.x, -s.a.x), sy = two_sum(s.b.y, -s.a.y), tx = two_sum(t.b.x, -t.a.x),
             ty = two_sum(t.b.y, -t.a.y);
  const Bounded part = cross(two_sum(t.a.x, -s.a.x), two_sum(t.a.y, -s.a.y), tx, ty), whole = cross(sx, sy, tx, ty);
  if (!(part.error > 0x1p-900 && whole.error > 0x1p-900)) return std::nullopt;  // low parts may underflow
  const double relative =
      1.001 * (part.error / std::abs(part.value.high) + whole.error / std::abs(whole.value.high) + kQuotient);
  if (!(relative < 0x1p-58)) return std::nullopt;
  const Pair along = over(part.value, whole.value);
  const Bounded x = walk(s.a.x, along, relative, sx), y = walk(s.a.y, along, relative, sy);
  if (!is_rounded(x) || !is_rounded(y)) return std::nullopt;
  const double off_x = std::abs(x.value.low) + x.error, off_y = std::abs(y.value.low) + y.error;
  return RoundedCrossing{{x.value.high, y.value.high}, (off_x + off_y) * (1 + 0x1p-50)};
}

}  // namespace taut::detail
