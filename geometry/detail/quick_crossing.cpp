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

twofold::Pair add(twofold::Pair a, twofold::Pair b) {
  const twofold::Pair high = twofold::two_sum(a.high, b.high), low = twofold::two_sum(a.low, b.low);
  const twofold::Pair middle = twofold::two_sum(high.high, high.low + low.high);
  return twofold::two_sum(middle.high, middle.low + low.low);
}
twofold::Pair negative(twofold::Pair a) { return {-a.high, -a.low}; }
twofold::Pair times(twofold::Pair a, twofold::Pair b) {
  const twofold::Pair p = twofold::two_product(a.high, b.high);
  return twofold::two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
twofold::Pair over(twofold::Pair a, twofold::Pair b) {
  const double q1 = a.high / b.high;
  const twofold::Pair rest = add(a, negative(times({q1, 0}, b)));
  const double q2 = rest.high / b.high;
  const double q3 = add(rest, negative(times({q2, 0}, b))).high / b.high;
  return add(twofold::two_sum(q1, q2), {q3, 0});
}

/// A value and how far off it may be.
struct Bounded {
  twofold::Pair value;
  double error = 0;
};

/// What v means, to within 2^-104 of it.
twofold::Pair meaning_pair(double v) {
  const auto d = written::decimal(v);
  if (!d || d->places <= 0 || d->places > 22) return {v, 0};
  // v is the decimal rounded, so what is left of the decimal is a double before it is divided.
  const double power = kPowersOfTen[d->places];
  const twofold::Pair back = twofold::two_product(v, power);
  return {v, ((static_cast<double>(d->digits) - back.high) - back.low) / power};
}

/// a x b, whose parts are each off by at most `error`.
Bounded cross(twofold::Pair ax, twofold::Pair ay, twofold::Pair bx, twofold::Pair by, double error) {
  const twofold::Pair p = times(ax, by), q = times(ay, bx);
  const double reach = std::abs(ax.high) + std::abs(ay.high) + std::abs(bx.high) + std::abs(by.high);
  return {add(p, negative(q)), 2 * kProduct * (std::abs(p.high) + std::abs(q.high)) + 2 * error * reach};
}

/// from + along * step, where `relative` bounds the relative error of `along` and `error` those of the others.
Bounded walk(twofold::Pair from, twofold::Pair along, double relative, twofold::Pair step, double error) {
  const twofold::Pair way = times(along, step);
  const twofold::Pair value = add(from, way);
  return {value, 1.001 * (std::abs(way.high) * (relative + kProduct) + std::abs(value.high) * kSum) + 3 * error};
}

/// The multiple of the unit that the value surely rounds to, and how far off; nothing when it may be a multiple itself
/// or half way between two.
std::optional<std::pair<double, double>> rounded(const Bounded& v, int places) {
  const twofold::Pair power{kPowersOfTen[places], 0};
  const twofold::Pair scaled = times(v.value, power);
  const double error = (v.error * power.high + std::abs(scaled.high) * kProduct) * 1.001;
  const double digits = std::nearbyint(scaled.high), rest = (scaled.high - digits) + scaled.low;
  if (std::abs(digits) > kLargestInteger || std::abs(rest) <= error || std::abs(rest) + error >= 0.5)
    return std::nullopt;
  return std::pair(digits / power.high, (std::abs(rest) + error) / power.high);
}

}  // namespace

std::optional<RoundedCrossing> quick_crossing(const Segment& s, const Segment& t, const DecimalUnit& unit) {
  for (const Point p : {s.a, s.b, t.a, t.b})
    if (std::max(std::abs(p.x), std::abs(p.y)) > 0x1p300) return std::nullopt;
  const int places = unit.places();
  if (places < 0 || places > 22) return std::nullopt;
  double size = 0;
  for (const Point p : {s.a, s.b, t.a, t.b}) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  const double error = size * 0x1p-100;  // of a coordinate and of a difference
  const twofold::Pair ax = meaning_pair(s.a.x), ay = meaning_pair(s.a.y), cx = meaning_pair(t.a.x),
                      cy = meaning_pair(t.a.y);
  const auto minus = [](double v, twofold::Pair from) { return add(meaning_pair(v), negative(from)); };
  const twofold::Pair sx = minus(s.b.x, ax), sy = minus(s.b.y, ay), tx = minus(t.b.x, cx), ty = minus(t.b.y, cy);
  const Bounded part = cross(add(cx, negative(ax)), add(cy, negative(ay)), tx, ty, error),
                whole = cross(sx, sy, tx, ty, error);
  if (!(part.error > 0x1p-900 && whole.error > 0x1p-900)) return std::nullopt;  // low parts may underflow
  const double relative =
      1.001 * (part.error / std::abs(part.value.high) + whole.error / std::abs(whole.value.high) + kQuotient);
  if (!(relative < 0x1p-58)) return std::nullopt;
  const twofold::Pair along = over(part.value, whole.value);
  const auto x = rounded(walk(ax, along, relative, sx, error), places),
             y = rounded(walk(ay, along, relative, sy, error), places);
  if (!x || !y) return std::nullopt;
  return RoundedCrossing{{x->first, y->first}, (x->second + y->second) * (1 + 0x1p-50)};
}

}  // namespace taut::detail
