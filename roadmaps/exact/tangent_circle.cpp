#include <taut/roadmaps/exact/tangent_circle.h>

#include <taut/geometry/written.h>

namespace taut {

namespace {

template <class Number>
struct Vector {
  Number x, y;
};

template <class Number>
Vector<Number> vector_of(const PlainDirection& v) {
  Number x = meant<Number>(v.to.x) - meant<Number>(v.from.x), y = meant<Number>(v.to.y) - meant<Number>(v.from.y);
  for (int i = 0; i < v.quarters; ++i) {
    const Number next = -y;
    y = x;
    x = next;
  }
  return {x, y};
}

/// The sign of a * b in the product that `times` makes of two vectors.
template <class Times>
int product_sign(const SurdDirection& a, const SurdDirection& b, Times times) {
  const Surd<Rational> P{times(a.ax, a.ay, b.ax, b.ay), times(a.bx, a.by, b.ax, b.ay)};
  const Surd<Rational> Q{times(a.ax, a.ay, b.bx, b.by), times(a.bx, a.by, b.bx, b.by)};
  return surd_sign(P, Q, a.R, b.R);
}

Rational cross(const Rational& ax, const Rational& ay, const Rational& bx, const Rational& by) {
  return ax * by - ay * bx;
}

Rational dot(const Rational& ax, const Rational& ay, const Rational& bx, const Rational& by) {
  return ax * bx + ay * by;
}

bool is_outer(const TangentPoint& p) { return p.here.side == p.other.side; }

/// The sign of f(Interval) or, when that cannot tell, of f(Rational).
template <class F>
int rational_sign(F f) {
  if (const auto known = sign(f(Interval()))) return *known;
  return sgn(f(Rational()));
}

}  // namespace

PlainDirection::PlainDirection(Point first, Point last, int turned) : from(first), to(last), quarters(turned) {
  const auto near = vector_of<Interval>(*this);
  x = near.x;
  y = near.y;
}

TangentPoint::TangentPoint(const TangentEnd& this_end, const TangentEnd& there, double radius)
    : here(this_end), other(there), r(radius) {
  const TangentFrame<Interval> frame(here, other, r);
  const Interval S = root(frame.R), side = -double(here.side);
  x = side * (frame.k * frame.dx - S * frame.dy) / frame.D;
  y = side * (frame.k * frame.dy + S * frame.dx) / frame.D;
}

SurdDirection TangentPoint::exact() const {
  const TangentFrame<Rational> frame(here, other, r);
  const Rational side = -here.side;
  return {side * frame.k * frame.dx, side * frame.k * frame.dy, -side * frame.dy, side * frame.dx, frame.R};
}

int cross_sign(const TangentPoint& a, const TangentPoint& b) {
  if (const auto known = sign(a.x * b.y - a.y * b.x)) return *known;
  if (is_outer(a) && is_outer(b))
    return a.here.side * b.here.side * written::orientation(a.here.centre, a.other.centre, b.other.centre);
  return product_sign(a.exact(), b.exact(), cross);
}

int dot_sign(const TangentPoint& a, const TangentPoint& b) {
  if (const auto known = sign(a.x * b.x + a.y * b.y)) return *known;
  return product_sign(a.exact(), b.exact(), dot);
}

int cross_sign(const TangentPoint& a, const SurdDirection& b) { return product_sign(a.exact(), b, cross); }

int cross_sign(const TangentPoint& a, const Rational& x, const Rational& y) {
  const SurdDirection e = a.exact();
  return surd_sign(cross(e.ax, e.ay, x, y), cross(e.bx, e.by, x, y), e.R);
}

int cross_sign(const TangentPoint& a, const PlainDirection& v) {
  if (const auto known = sign(a.x * v.y - a.y * v.x)) return *known;
  const auto exact = vector_of<Rational>(v);
  return cross_sign(a, exact.x, exact.y);
}

Interval angle_between(const TangentPoint& a, const TangentPoint& b) {
  const Interval sine = a.x * b.y - a.y * b.x, cosine = a.x * b.x + a.y * b.y;
  const double angle = std::atan2(std::abs(sine.middle()), cosine.middle());
  // Of unit vectors: the angle moves no more than sine and cosine do together.
  const double error = 1.001 * (sine.width() + cosine.width()) + 8 * 0x1p-53 * angle;
  return {std::max(0.0, angle - error), angle + error};
}

std::optional<PlainDirection> direction_forbidden(Point c, double r, Point w, Point v) {
  // The sign of (v - w) (c - w), and of (w - v) (c - v).
  const auto before = [&](Point p, Point q) {
    return rational_sign([&](auto zero) {
      using Number = decltype(zero);
      const Number fx = meant<Number>(q.x) - meant<Number>(p.x), fy = meant<Number>(q.y) - meant<Number>(p.y);
      const Number x = meant<Number>(c.x) - meant<Number>(p.x), y = meant<Number>(c.y) - meant<Number>(p.y);
      Number result = fx * x + fy * y;
      return result;
    });
  };
  const auto end = [&](Point p) -> std::optional<PlainDirection> {
    const int order = rational_sign([&](auto zero) {
      using Number = decltype(zero);
      const Number x = meant<Number>(p.x) - meant<Number>(c.x), y = meant<Number>(p.y) - meant<Number>(c.y),
                   reach = Number(2.0) * meant<Number>(r);
      Number result = x * x + y * y - reach * reach;
      return result;
    });
    if (order >= 0) return std::nullopt;
    return PlainDirection{c, p, 0};
  };
  if (before(w, v) <= 0) return end(w);
  if (before(v, w) <= 0) return end(v);
  const int order = rational_sign([&](auto zero) {
    using Number = decltype(zero);
    const Number fx = meant<Number>(v.x) - meant<Number>(w.x), fy = meant<Number>(v.y) - meant<Number>(w.y);
    const Number x = meant<Number>(c.x) - meant<Number>(w.x), y = meant<Number>(c.y) - meant<Number>(w.y),
                 reach = Number(2.0) * meant<Number>(r);
    const Number off = fx * y - fy * x;
    Number result = off * off - reach * reach * (fx * fx + fy * fy);
    return result;
  });
  if (order >= 0) return std::nullopt;
  // c to the left of w -> v: the wall is to the right of c, a quarter turn back.
  return PlainDirection{w, v, written::orientation(w, v, c) > 0 ? 3 : 1};
}

}  // namespace taut
