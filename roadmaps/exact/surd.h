// Signs of numbers with one or two square roots: enclosed first, exact when the enclosure cannot tell. Private.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/written.h>

namespace taut::detail {

/// An enclosure of a real number. Every operation widens by more than it rounds; what overflows encloses everything.
struct Range {
  double lo = 0;
  double hi = 0;

  Range() = default;
  Range(double v) : lo(v), hi(v) {}  // NOLINT: a double is a number, like an mpq_class's argument
  Range(double l, double h) : lo(l), hi(h) {}

  double middle() const { return lo + (hi - lo) / 2; }
  double width() const { return hi - lo; }
};

inline Range widened(double lo, double hi) {
  lo -= std::abs(lo) * 0x1p-52 + 1e-300;
  hi += std::abs(hi) * 0x1p-52 + 1e-300;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  return lo >= -1e290 && hi <= 1e290 ? Range(lo, hi) : Range(-kInfinite, kInfinite);
}

/// What a coordinate or a radius means (written.h).
template <class Number>
Number meant(double v);
template <>
inline Range meant<Range>(double v) {
  const Interval i = written::enclosure(v);
  return {i.lo, i.hi};
}
template <>
inline mpq_class meant<mpq_class>(double v) {
  return meaning(v);
}

inline Range operator-(const Range& a) { return {-a.hi, -a.lo}; }
inline Range operator+(const Range& a, const Range& b) { return widened(a.lo + b.lo, a.hi + b.hi); }
inline Range operator-(const Range& a, const Range& b) { return widened(a.lo - b.hi, a.hi - b.lo); }
inline Range operator*(const Range& a, const Range& b) {
  const double p = a.lo * b.lo, q = a.lo * b.hi, s = a.hi * b.lo, t = a.hi * b.hi;
  if (p == 0 && q == 0 && s == 0 && t == 0 && (a.lo == 0 || b.lo == 0) && (a.hi == 0 || b.hi == 0)) return 0;
  return widened(std::min(std::min(p, q), std::min(s, t)), std::max(std::max(p, q), std::max(s, t)));
}
/// Precondition: b > 0.
inline Range operator/(const Range& a, const Range& b) {
  return widened(std::min(a.lo / b.lo, a.lo / b.hi), std::max(a.hi / b.lo, a.hi / b.hi));
}
/// Of what is left of a number that is >= 0.
inline Range root(const Range& a) { return widened(std::sqrt(std::max(0.0, a.lo)), std::sqrt(std::max(0.0, a.hi))); }

inline std::optional<int> sign(const Range& a) {
  if (a.lo > 0) return 1;
  if (a.hi < 0) return -1;
  if (a.lo == 0 && a.hi == 0) return 0;
  return std::nullopt;
}

/// a + b * sqrt(R), R >= 0 being known from elsewhere.
template <class Number>
struct Surd {
  Number a;
  Number b;
};

/// The sign of a + b * sqrt(R).
inline int surd_sign(const mpq_class& a, const mpq_class& b, const mpq_class& R) {
  const int sa = sgn(a), sb = sgn(R) == 0 ? 0 : sgn(b);
  if (sb == 0 || sa == sb) return sa;
  if (sa == 0) return sb;
  const mpq_class left = a * a, right = b * b * R;
  const int order = cmp(left, right);
  return order > 0 ? sa : order < 0 ? sb : 0;
}

/// The sign of P + Q * sqrt(R2), where P and Q are surds over R1.
inline int surd_sign(const Surd<mpq_class>& P, const Surd<mpq_class>& Q, const mpq_class& R1, const mpq_class& R2) {
  const int sp = surd_sign(P.a, P.b, R1), sq = sgn(R2) == 0 ? 0 : surd_sign(Q.a, Q.b, R1);
  if (sq == 0 || sp == sq) return sp;
  if (sp == 0) return sq;
  const mpq_class a = P.a * P.a + P.b * P.b * R1 - R2 * (Q.a * Q.a + Q.b * Q.b * R1);
  const mpq_class b = 2 * (P.a * P.b - R2 * Q.a * Q.b);
  const int order = surd_sign(a, b, R1);
  return order > 0 ? sp : order < 0 ? sq : 0;
}

}  // namespace taut::detail
