// A leg's tangents, arc and pivot. Private.
#pragma once

#include <cstdint>

#include <taut/robots/car/detail/sweep_numbers.h>
#include <taut/robots/car/leg.h>

namespace taut::car::detail {

/// Exact integers of two headings: sine and cosine of the turn between them, times kHeadingScale^2.
struct Turn {
  explicit Turn(int from, int to) {
    const HeadingVector a = heading_vector(from), b = heading_vector(to);
    sine = std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
    cosine = std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y;
  }
  int sense() const { return sine > 0 ? 1 : sine < 0 ? -1 : 0; }

  std::int64_t sine, cosine;
  static constexpr std::int64_t kOne = std::int64_t{kHeadingScale} * kHeadingScale;
};

/// Relative to leg.from.at. Q is Approx or Rational. Precondition: the headings differ by less than 180 degrees.
template <class Q>
struct LegGeometry {
  explicit LegGeometry(const Leg& leg)
      : to(difference<Q>(leg.from.at, leg.to.at)),
        u(unit<Q>(leg.from.heading)),
        v(unit<Q>(leg.to.heading)),
        gear(leg.backward ? -1 : 1) {
    const Turn turn(leg.from.heading, leg.to.heading);
    sense = turn.sense();
    const Q g(gear), one(static_cast<double>(Turn::kOne));
    if (sense == 0) {
      t1 = before = g * dot(to, u);
      t2 = after = radius = Q(0);
      return;
    }
    sine = Q(static_cast<double>(turn.sine)) / one;
    cosine = Q(static_cast<double>(turn.cosine)) / one;
    t1 = g * cross(to, v) / sine;
    t2 = g * cross(u, to) / sine;
    const Q more = t1 - t2;
    before = positive(more);
    after = positive(Q(-more));
    tangent = Q(sense) * sine / (Q(1) + cosine);
    radius = smaller(t1, t2) / tangent;
    pivot = (g * before) * u + (Q(sense * gear) * radius) * left_of(u);
  }

  Vec<Q> to, u, v;
  int gear;
  int sense = 0;            ///< of the turn; 0: straight
  Q t1, t2;                 ///< to where the tangents meet
  Q before, after, radius;  ///< as of LegCurve
  Q sine, cosine;           ///< of the turn
  Q tangent;                ///< of half the turn's size
  Vec<Q> pivot{};

 private:
  static Approx positive(Approx a) { return {a.v > 0 ? a.v : 0, a.e}; }
  static Rational positive(const Rational& a) { return sgn(a) > 0 ? a : Rational(0); }
  static Approx smaller(Approx a, Approx b) { return {a.v < b.v ? a.v : b.v, a.e > b.e ? a.e : b.e}; }
  static Rational smaller(const Rational& a, const Rational& b) { return a < b ? a : b; }
};

}  // namespace taut::car::detail
