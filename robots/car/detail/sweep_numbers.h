// The numbers that sweeps are decided with: doubles that know their error, and rationals with an infinitesimal.
// Private.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/robots/car/heading.h>

namespace taut::car::detail {

/// A double v that is at most e from the exact value. Running error analysis (Wilkinson): each operation adds what it
/// rounds. Errors are themselves rounded, which `sign` allows for.
struct Approx {
  double v = 0;
  double e = 0;

  static constexpr double kUnit = 1.2e-16;  // above 2^-53
  static constexpr double kTiny = 1e-300;   // above what underflow loses

  Approx() = default;
  Approx(double value) : v(value) {}  // NOLINT(google-explicit-constructor): a double is its own value
  Approx(double value, double error) : v(value), e(error) {}

  friend Approx operator+(Approx a, Approx b) { return rounded(a.v + b.v, a.e + b.e); }
  friend Approx operator-(Approx a, Approx b) { return rounded(a.v - b.v, a.e + b.e); }
  friend Approx operator-(Approx a) { return {-a.v, a.e}; }
  friend Approx operator*(Approx a, Approx b) {
    return rounded(a.v * b.v, std::abs(a.v) * b.e + std::abs(b.v) * a.e + a.e * b.e + kTiny);
  }
  /// Precondition: b is certainly not 0.
  friend Approx operator/(Approx a, Approx b) {
    const double value = a.v / b.v;
    return rounded(value, (a.e + std::abs(value) * b.e) / (std::abs(b.v) - b.e) + kTiny);
  }

 private:
  static Approx rounded(double value, double error) { return {value, error + kUnit * std::abs(value)}; }
};

/// A polynomial in an infinitesimal eps > 0 with rational coefficients, ordered by its lowest one that is not 0.
struct Infinitesimal {
  std::vector<Rational> c;

  Infinitesimal(Rational value = 0) : c{std::move(value)} {}  // NOLINT(google-explicit-constructor)
  Infinitesimal(double value) : c{Rational(value)} {}         // NOLINT(google-explicit-constructor)
  Infinitesimal(int value) : c{Rational(value)} {}            // NOLINT(google-explicit-constructor)

  friend Infinitesimal operator+(Infinitesimal a, const Infinitesimal& b) {
    a.c.resize(std::max(a.c.size(), b.c.size()));
    for (std::size_t i = 0; i < b.c.size(); ++i) a.c[i] += b.c[i];
    return a;
  }
  friend Infinitesimal operator-(Infinitesimal a, const Infinitesimal& b) {
    a.c.resize(std::max(a.c.size(), b.c.size()));
    for (std::size_t i = 0; i < b.c.size(); ++i) a.c[i] -= b.c[i];
    return a;
  }
  friend Infinitesimal operator-(Infinitesimal a) {
    for (Rational& x : a.c) x = -x;
    return a;
  }
  friend Infinitesimal operator*(const Infinitesimal& a, const Infinitesimal& b) {
    Infinitesimal product;
    product.c.assign(a.c.size() + b.c.size() - 1, 0);
    for (std::size_t i = 0; i < a.c.size(); ++i)
      for (std::size_t k = 0; k < b.c.size(); ++k) product.c[i + k] += a.c[i] * b.c[k];
    return product;
  }
};

/// Signs, and whether one of those given out is a guess (0).
template <class N>
struct Signs;

template <>
struct Signs<Approx> {
  bool doubt = false;
  int operator()(Approx a) {
    const double e = a.e * (1 + 1e-9);
    if (a.v > e) return 1;
    if (a.v < -e) return -1;
    doubt = doubt || !(a.v == 0 && a.e == 0);
    return 0;
  }
};

template <>
struct Signs<Rational> {
  static constexpr bool doubt = false;
  int operator()(const Rational& a) const { return sgn(a); }
};

template <>
struct Signs<Infinitesimal> {
  static constexpr bool doubt = false;
  int operator()(const Infinitesimal& a) const {
    for (const Rational& x : a.c)
      if (sgn(x) != 0) return sgn(x);
    return 0;
  }
};

/// A side of the car moved inwards by the infinitesimal, where there is one: what touches the car does not meet it
/// then.
template <class N>
N drawn_in(double size) {
  return N(size);
}
template <>
inline Infinitesimal drawn_in<Infinitesimal>(double size) {
  Infinitesimal number{Rational(size)};
  number.c.emplace_back(-1);
  return number;
}

template <class N>
struct Vec {
  N x, y;
  friend Vec operator+(const Vec& a, const Vec& b) { return {N(a.x + b.x), N(a.y + b.y)}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {N(a.x - b.x), N(a.y - b.y)}; }
  friend Vec operator-(const Vec& a) { return {N(-a.x), N(-a.y)}; }
  friend Vec operator*(const N& k, const Vec& a) { return {N(k * a.x), N(k * a.y)}; }
};
template <class N>
N cross(const Vec<N>& a, const Vec<N>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class N>
N dot(const Vec<N>& a, const Vec<N>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class N>
Vec<N> left_of(const Vec<N>& a) {
  return {N(-a.y), a.x};
}

/// b - a. Of Approx: one rounding each.
template <class N>
Vec<N> difference(Point a, Point b) {
  return {N(N(b.x) - N(a.x)), N(N(b.y) - N(a.y))};
}

template <class N>
Vec<N> unit(int heading) {
  const HeadingVector h = heading_vector(heading);
  return {N(N(h.x) / N(kHeadingScale)), N(N(h.y) / N(kHeadingScale))};
}

}  // namespace taut::car::detail
