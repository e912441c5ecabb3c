// Does a moving rectangle meet a segment? Signs only: no root, no sample. Private.
#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include <taut/robots/car/detail/leg_geometry.h>

namespace taut::car::detail {

enum class Answer : std::uint8_t { no, yes, doubt };

/// N is Approx (answers may be `doubt`), Rational (the closed rectangle: touching is meeting), or Infinitesimal (the
/// open one: exact). Everything is relative to leg.from.at.

/// A rectangle along a heading.
template <class N>
struct Rectangle {
  Vec<N> origin, along;
  N low, high, half;
};

template <class N>
Answer meets(const Rectangle<N>& r, const Vec<N>& a, const Vec<N>& b) {
  Signs<N> sign;
  const Vec<N> left = left_of(r.along), d = b - a;
  const auto beyond = [&](const N& p, const N& q, const N& limit) {
    return sign(N(p - limit)) > 0 && sign(N(q - limit)) > 0;
  };
  const N ax = dot(r.along, Vec<N>(a - r.origin)), bx = dot(r.along, Vec<N>(b - r.origin));
  if (beyond(ax, bx, r.high) || beyond(N(-ax), N(-bx), N(-r.low))) return Answer::no;
  const N ay = dot(left, Vec<N>(a - r.origin)), by = dot(left, Vec<N>(b - r.origin));
  if (beyond(ay, by, r.half) || beyond(N(-ay), N(-by), r.half)) return Answer::no;
  // All four corners on one side of the line? In the rectangle's frame.
  const N dx = dot(r.along, d), dy = dot(left, d);
  int above = 0, below = 0;
  for (const N& x : {r.low, r.high})
    for (const N& y : {N(-r.half), r.half}) {
      const int side = sign(N(dx * (y - ay) - dy * (x - ax)));
      above += side > 0;
      below += side < 0;
    }
  if (above == 4 || below == 4) return Answer::no;
  return sign.doubt ? Answer::doubt : Answer::yes;
}

/// Does the closed arc around the origin, counter-clockwise from p to q by less than 180 degrees, meet the closed
/// segment a b? The segment is clipped to the wedge of p and q; on what is left, |X|^2 - |p|^2 is one convex quadratic.
template <class N>
Answer arc_meets(const Vec<N>& p, const Vec<N>& q, const Vec<N>& a, const Vec<N>& b) {
  Signs<N> sign;
  const Vec<N> d = b - a;
  const N fa = cross(p, a), fb = cross(p, b), ga = cross(a, q), gb = cross(b, q);
  const int sfa = sign(fa), sfb = sign(fb), sga = sign(ga), sgb = sign(gb);
  if ((sfa < 0 && sfb < 0) || (sga < 0 && sgb < 0)) return Answer::no;
  const N square = dot(p, p), off = cross(a, d);
  if (sign(N(dot(a, a) - square)) < 0 && sign(N(dot(b, b) - square)) < 0) return Answer::no;
  if (sign(N(off * off - square * dot(d, d))) > 0) return Answer::no;
  if (sign.doubt) return Answer::doubt;

  // The part of the segment in the wedge, from n/m to n/m of it.
  struct Part {
    N n, m;
  };
  Part low{N(0), N(1)}, high{N(1), N(1)};
  const auto clip = [&](const N& at_a, const N& at_b, int sign_a, int sign_b) {
    if (sign_a < 0) {
      const Part part{N(-at_a), N(at_b - at_a)};
      if (sign(N(part.n * low.m - low.n * part.m)) > 0) low = part;
    } else if (sign_b < 0) {
      const Part part{at_a, N(at_a - at_b)};
      if (sign(N(part.n * high.m - high.n * part.m)) < 0) high = part;
    }
  };
  clip(fa, fb, sfa, sfb);
  clip(ga, gb, sga, sgb);
  if (sign(N(low.n * high.m - high.n * low.m)) > 0) return Answer::no;
  const Vec<N> first = low.m * a + low.n * d, last = high.m * a + high.n * d;
  const int at_first = sign(N(dot(first, first) - square * low.m * low.m));
  const int at_last = sign(N(dot(last, last) - square * high.m * high.m));
  if (at_first < 0 && at_last < 0) return Answer::no;
  if (at_first > 0 && at_last > 0 && (sign(dot(first, d)) > 0 || sign(dot(last, d)) < 0)) return Answer::no;
  return sign.doubt ? Answer::doubt : Answer::yes;
}

/// The car turning around a pivot. The four corners, front left, rear left, rear right, front right, before and after,
/// from the pivot.
template <class N>
struct ArcSweep {
  Vec<N> pivot;
  std::array<Vec<N>, 4> first, last;
  N cosine, sine;
  int sense;
};

/// Does the closed segment meet the car on its way, if it does not meet it at the beginning? It does iff
///  - a corner's arc meets the segment, or
///  - an end of the segment, turned the other way, meets a side of the car as it stands at the beginning.
/// For at the first moment of contact the two touch in boundary points alone, so they share a part of a line in a side
/// of the car: a point or a segment, and each end of that is a corner of the car or an end of the segment. That covers
/// short segments which only a side sweeps over (their ends cross that side) and the bulge of a side beyond its
/// corners' arcs.
template <class N>
Answer meets(const ArcSweep<N>& s, const Vec<N>& a, const Vec<N>& b) {
  bool doubt = false;
  const auto is_met = [&](const Vec<N>& from, const Vec<N>& to, bool ccw, const Vec<N>& c, const Vec<N>& d) {
    const Answer answer = ccw ? arc_meets(from, to, c, d) : arc_meets(to, from, c, d);
    doubt = doubt || answer == Answer::doubt;
    return answer == Answer::yes;
  };
  const Vec<N> pa = a - s.pivot, pb = b - s.pivot;
  for (std::size_t k = 0; k < 4; ++k)
    if (is_met(s.first[k], s.last[k], s.sense > 0, pa, pb)) return Answer::yes;
  for (const Vec<N>& end : {pa, pb}) {
    const N& c = s.cosine;
    const N& i = s.sine;
    const Vec<N> back{N(c * end.x + i * end.y), N(c * end.y - i * end.x)};
    for (std::size_t k = 0; k < 4; ++k)
      if (is_met(end, back, s.sense < 0, s.first[k], s.first[(k + 1) % 4])) return Answer::yes;
  }
  return doubt ? Answer::doubt : Answer::no;
}

/// All that a leg sweeps over. The rectangle of a straight piece of length 0 is left out where that is certain and the
/// pose is covered by its neighbour: at the beginning, which the caller knows to be free, and at the end, which the arc
/// includes.
template <class N>
struct LegSweep {
  using Constant = std::conditional_t<std::is_same_v<N, Approx>, Approx, Rational>;

  LegSweep(const Leg& leg, const CarShape& shape) {
    const LegGeometry<Constant> g(leg);
    sense = g.sense;
    const N front = drawn_in<N>(shape.front), back = drawn_in<N>(shape.back), half = drawn_in<N>(shape.half_width);
    const auto rectangle = [&](const Vec<Constant>& origin, const Vec<Constant>& along, const Constant& behind,
                               const Constant& ahead) {
      return Rectangle<N>{convert(origin), convert(along), N(-back - N(behind)), N(front + N(ahead)), half};
    };
    const Constant none(0);
    const bool ahead = g.gear > 0;
    before = rectangle({none, none}, g.u, ahead ? none : g.before, ahead ? g.before : none);
    if (sense == 0) return;
    after = rectangle(g.to, g.v, ahead ? g.after : none, ahead ? none : g.after);
    Signs<Constant> sign;
    const int longer = sign(Constant(g.t1 - g.t2));
    has_before = longer > 0 || sign.doubt;
    has_after = longer < 0 || sign.doubt;
    const Vec<N> u = convert(g.u), pose = convert(Vec<Constant>(Constant(Constant(g.gear) * g.before) * g.u - g.pivot));
    arc.pivot = convert(g.pivot);
    arc.cosine = N(g.cosine);
    arc.sine = N(g.sine);
    arc.sense = sense;
    const std::array<Vec<N>, 4> body{{{front, half}, {N(-back), half}, {N(-back), N(-half)}, {front, N(-half)}}};
    for (std::size_t k = 0; k < 4; ++k) {
      arc.first[k] = pose + body[k].x * u + body[k].y * left_of(u);
      const Vec<N>& f = arc.first[k];
      arc.last[k] = {N(arc.cosine * f.x - arc.sine * f.y), N(arc.sine * f.x + arc.cosine * f.y)};
    }
  }

  /// Of the segment a b, given relative to leg.from.at, where the car does not meet it.
  Answer met_by(const Vec<N>& a, const Vec<N>& b) const {
    const Answer first = has_before ? meets(before, a, b) : Answer::no;
    if (first == Answer::yes || sense == 0) return first;
    const Answer second = meets(arc, a, b);
    if (second == Answer::yes && first == Answer::no) return second;
    const Answer third = has_after ? meets(after, a, b) : Answer::no;
    if (third == Answer::yes) return third;
    return first == Answer::no && second == Answer::no && third == Answer::no ? Answer::no : Answer::doubt;
  }

  int sense = 0;
  bool has_before = true, has_after = false;
  Rectangle<N> before{}, after{};
  ArcSweep<N> arc{};

 private:
  static Vec<N> convert(const Vec<Constant>& a) { return {N(a.x), N(a.y)}; }
};

}  // namespace taut::car::detail
