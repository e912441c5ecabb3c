// One leg's length in plain doubles: a value, what is missing from it, and a proven bound on what is still missing
// then.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include <taut/geometry/interval.h>

namespace taut::twofold {

/// The unevaluated sum high + low, with high = the double nearest to it.
struct Pair {
  double high = 0;
  double low = 0;

  friend bool operator==(const Pair&, const Pair&) = default;
};

/// a + b, exactly (Knuth).
inline Pair two_sum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// The upper 26 bits of v; the rest, v - upper_half(v), has 26 as well (Veltkamp). Precondition: |v| < 2^995.
inline double upper_half(double v) {
  const double c = 134217729.0 * v;
  return c - (c - v);
}

/// a * b, exactly while nothing underflows and |a|, |b| < 2^995 (Dekker; or one fused operation).
inline Pair two_product(double a, double b) {
  const double product = a * b;
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
  return {product, std::fma(a, b, -product)};
#else
  const double ah = upper_half(a), al = a - ah, bh = upper_half(b), bl = b - bh;
  return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
#endif
}

/// The next double below or above v when `step`, else v; without a branch, which would be taken at random.
/// Precondition: v > 0 and finite, or v = 0 and not step.
inline double step_down(double v, bool step) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) - step); }
inline double step_up(double v, bool step) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) + step); }

/// a + b rounded down or up, exactly as directed rounding would. Precondition: a, b >= 0, finite.
inline double add_down(double a, double b) {
  const Pair s = two_sum(a, b);
  return step_down(s.high, s.low < 0);
}
inline double add_up(double a, double b) {
  const Pair s = two_sum(a, b);
  return step_up(s.high, s.low > 0);
}

/// The squared length of a leg. `sum` is the double nearest to dx^2 + dy^2 (within 2^-51 of it), `low` the
/// double-double tail; `exact` says that `sum` is the square itself. Meaningful for regular legs only.
struct Square {
  Pair dx, dy;  ///< |x1 - x2|, |y1 - y2|, exactly
  double sum = 0;
  double low = 0;
  bool exact = false;
};

/// Neither squares nor their rounding errors overflow or underflow.
inline bool is_regular(double d) { return d == 0 || (d > 1e-130 && d < 1e140); }
inline bool is_regular(const Square& s) { return is_regular(s.dx.high) && is_regular(s.dy.high); }

inline Pair absolute_difference(double a, double b) {
  const Pair d = two_sum(a, -b);
  return d.high < 0 ? Pair{-d.high, -d.low} : d;
}

inline Square square_of(Pair dx, Pair dy) {
  Square s{.dx = dx, .dy = dy};
  const double xx = dx.high * dx.high, yy = dy.high * dy.high;
  const Pair sum = two_sum(xx, yy);
  s.sum = sum.high;
  s.low = sum.low;
  // Differences of 26 bits, as on every grid, have exact squares.
  const bool is_short = upper_half(dx.high) == dx.high && upper_half(dy.high) == dy.high && dx.low == 0 && dy.low == 0;
  if (!is_short) {
    const double xx_low = two_product(dx.high, dx.high).low, yy_low = two_product(dy.high, dy.high).low;
    s.low += (xx_low + yy_low) + 2 * (dx.high * dx.low + dy.high * dy.low);
    s.exact = sum.low == 0 && xx_low == 0 && yy_low == 0 && dx.low == 0 && dy.low == 0;
  } else {
    s.exact = sum.low == 0;
  }
  return s;
}

/// Is the length itself |x1 - x2| or |y1 - y2|?
inline bool is_axis_parallel(const Square& s) { return s.dx.high == 0 || s.dy.high == 0; }

/// The root of an exact square: itself, or two neighbours. A rounded root errs on the side its own square tells.
inline Interval enclose_root(double square) {
  const double r = std::sqrt(square);
  const Pair back = two_product(r, r);
  const double rest = (square - back.high) - back.low;
  return {step_down(r, rest < 0), step_up(r, rest > 0)};
}

/// A length: high + low, off by at most kRootError * high; `exact` says that it is this sum itself.
struct Root {
  double high = 0;
  double low = 0;
  bool exact = false;
};

/// 2^-98. With u = 2^-53: the tail of the square is below 6u of it and known to 31u^2; one Newton step leaves
/// 4.5u^2 and its rounding 3u^2; together 23u^2 < 2^-101.
inline constexpr double kRootError = 0x1p-98;

inline Root root_of(double sum, double low, bool exact) {
  const double r = std::sqrt(sum);
  if (r == 0) return {0, 0, true};
  const Pair back = two_product(r, r);
  const double rest = (sum - back.high) - back.low;  // exact for a correctly rounded root
  if (exact && rest == 0) return {r, 0, true};
  const double step = (rest + low) / (2 * r);
  const double high = r + step;
  return {high, (r - high) + step, false};
}

inline Root root_of(const Square& s) {
  if (!is_axis_parallel(s)) return root_of(s.sum, s.low, s.exact);
  const Pair& d = s.dx.high == 0 ? s.dy : s.dx;
  return {d.high, d.low, true};
}

}  // namespace taut::twofold
