// Numbers that are known to lie between two doubles, and arithmetic on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace taut {

/// A closed interval of doubles that contains an exact value. Every operation below widens by more than it rounds; what
/// overflows encloses everything.
struct Interval {
  double lo = 0;
  double hi = 0;

  Interval() = default;
  Interval(double v) : lo(v), hi(v) {}  // NOLINT(google-explicit-constructor): a double is a number
  Interval(double low, double high) : lo(low), hi(high) {}

  double middle() const { return lo + (hi - lo) / 2; }
  double width() const { return hi - lo; }

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// [lo, hi] with room for the rounding of both.
inline Interval widened(double lo, double hi) {
  lo -= std::abs(lo) * 0x1p-52 + 1e-300;
  hi += std::abs(hi) * 0x1p-52 + 1e-300;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  return lo >= -1e290 && hi <= 1e290 ? Interval(lo, hi) : Interval(-kInfinite, kInfinite);
}

inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }
inline Interval operator+(const Interval& a, const Interval& b) { return widened(a.lo + b.lo, a.hi + b.hi); }
inline Interval operator-(const Interval& a, const Interval& b) { return widened(a.lo - b.hi, a.hi - b.lo); }
inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.lo * b.lo, q = a.lo * b.hi, s = a.hi * b.lo, t = a.hi * b.hi;
  if (p == 0 && q == 0 && s == 0 && t == 0 && (a.lo == 0 || b.lo == 0) && (a.hi == 0 || b.hi == 0)) return 0;
  return widened(std::min(std::min(p, q), std::min(s, t)), std::max(std::max(p, q), std::max(s, t)));
}
/// Precondition: b > 0.
inline Interval operator/(const Interval& a, const Interval& b) {
  return widened(std::min(a.lo / b.lo, a.lo / b.hi), std::max(a.hi / b.lo, a.hi / b.hi));
}
/// Of what is left of a number that is >= 0.
inline Interval root(const Interval& a) {
  return widened(std::sqrt(std::max(0.0, a.lo)), std::sqrt(std::max(0.0, a.hi)));
}

/// Nothing where the interval holds numbers of two signs.
inline std::optional<int> sign(const Interval& a) {
  if (a.lo > 0) return 1;
  if (a.hi < 0) return -1;
  if (a.lo == 0 && a.hi == 0) return 0;
  return std::nullopt;
}

}  // namespace taut
