// Signs of numbers with one or two square roots: enclosed first, exact when the enclosure cannot tell.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/interval.h>
#include <taut/geometry/written.h>

namespace taut {

/// What a coordinate or a radius means (written.h).
template <class Number>
Number meant(double v);
template <>
inline Interval meant<Interval>(double v) {
  return written::enclosure(v);
}
template <>
inline Rational meant<Rational>(double v) {
  return meaning(v);
}

/// a + b * sqrt(R), R >= 0 being known from elsewhere.
template <class Number>
struct Surd {
  Number a;
  Number b;
};

/// The sign of a + b * sqrt(R).
inline int surd_sign(const Rational& a, const Rational& b, const Rational& R) {
  const int sa = sgn(a), sb = sgn(R) == 0 ? 0 : sgn(b);
  if (sb == 0 || sa == sb) return sa;
  if (sa == 0) return sb;
  const Rational left = a * a, right = b * b * R;
  const int order = cmp(left, right);
  return order > 0 ? sa : order < 0 ? sb : 0;
}

/// The sign of P + Q * sqrt(R2), where P and Q are surds over R1.
inline int surd_sign(const Surd<Rational>& P, const Surd<Rational>& Q, const Rational& R1, const Rational& R2) {
  const int sp = surd_sign(P.a, P.b, R1), sq = sgn(R2) == 0 ? 0 : surd_sign(Q.a, Q.b, R1);
  if (sq == 0 || sp == sq) return sp;
  if (sp == 0) return sq;
  const Rational a = P.a * P.a + P.b * P.b * R1 - R2 * (Q.a * Q.a + Q.b * Q.b * R1);
  const Rational b = 2 * (P.a * P.b - R2 * Q.a * Q.b);
  const int order = surd_sign(a, b, R1);
  return order > 0 ? sp : order < 0 ? sq : 0;
}

}  // namespace taut
