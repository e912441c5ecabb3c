#include <taut/geometry/detail/quick_crossing.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/detail/written_integers.h>
#include <taut/geometry/exact/twofold.h>
#include <taut/geometry/written.h>

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

/// What v means, to within 2^-104 of it.
Pair meaning_pair(double v) {
  const auto d = written::decimal(v);
  if (!d || d->places <= 0 || d->places > 22) return {v, 0};
  // v is the decimal rounded, so what is left of the decimal is a double before it is divided.
  const double power = kPowersOfTen[d->places];
  const Pair back = two_product(v, power);
  return {v, ((static_cast<double>(d->digits) - back.high) - back.low) / power};
}

/// a x b, whose parts are each off by at most `error`.
Bounded cross(Pair ax, Pair ay, Pair bx, Pair by, double error) {
  const Pair p = times(ax, by), q = times(ay, bx);
  const double reach = std::abs(ax.high) + std::abs(ay.high) + std::abs(bx.high) + std::abs(by.high);
  return {add(p, negative(q)), 2 * kProduct * (std::abs(p.high) + std::abs(q.high)) + 2 * error * reach};
}

/// from + along * step, where `relative` bounds the relative error of `along` and `error` those of the others.
Bounded walk(Pair from, Pair along, double relative, Pair step, double error) {
  const Pair way = times(along, step);
  const Pair value = add(from, way);
  return {value, 1.001 * (std::abs(way.high) * (relative + kProduct) + std::abs(value.high) * kSum) + 3 * error};
}

/// The multiple of the unit that the value surely rounds to, and how far off; nothing when it may be a multiple itself
/// or half way between two.
std::optional<std::pair<double, double>> rounded(const Bounded& v, int places) {
  const Pair power{kPowersOfTen[places], 0};
  const Pair scaled = times(v.value, power);
  const double error = (v.error * power.high + std::abs(scaled.high) * kProduct) * 1.001;
  const double digits = std::nearbyint(scaled.high), rest = (scaled.high - digits) + scaled.low;
  if (std::abs(digits) > kLargestInteger || std::abs(rest) <= error || std::abs(rest) + error >= 0.5)
    return std::nullopt;
  return std::pair(digits / power.high, (std::abs(rest) + error) / power.high);
}

}  // namespace

std::optional<RoundedCrossing> quick_crossing(const Segment& s, const Segment& t, const Unit& unit) {
  for (const Point p : {s.a, s.b, t.a, t.b})
    if (std::max(std::abs(p.x), std::abs(p.y)) > 0x1p300) return std::nullopt;
  const int places = unit.places();
  if (places < 0 || places > 22) return std::nullopt;
  double size = 0;
  for (const Point p : {s.a, s.b, t.a, t.b}) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  const double error = size * 0x1p-100;  // of a coordinate and of a difference
  const Pair ax = meaning_pair(s.a.x), ay = meaning_pair(s.a.y), cx = meaning_pair(t.a.x), cy = meaning_pair(t.a.y);
  const auto minus = [](double v, Pair from) { return add(meaning_pair(v), negative(from)); };
  const Pair sx = minus(s.b.x, ax), sy = minus(s.b.y, ay), tx = minus(t.b.x, cx), ty = minus(t.b.y, cy);
  const Bounded part = cross(add(cx, negative(ax)), add(cy, negative(ay)), tx, ty, error),
                whole = cross(sx, sy, tx, ty, error);
  if (!(part.error > 0x1p-900 && whole.error > 0x1p-900)) return std::nullopt;  // low parts may underflow
  const double relative =
      1.001 * (part.error / std::abs(part.value.high) + whole.error / std::abs(whole.value.high) + kQuotient);
  if (!(relative < 0x1p-58)) return std::nullopt;
  const Pair along = over(part.value, whole.value);
  const auto x = rounded(walk(ax, along, relative, sx, error), places),
             y = rounded(walk(ay, along, relative, sy, error), places);
  if (!x || !y) return std::nullopt;
  return RoundedCrossing{{x->first, y->first}, (x->second + y->second) * (1 + 0x1p-50)};
}

}  // namespace taut::detail
