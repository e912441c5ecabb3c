// A common tangent of two circles, and exactly what it touches.
#pragma once
#include <memory>

#include <taut/geometry/point.h>
#include <taut/roadmaps/exact/surd.h>

namespace taut {

/// What a path is tangent to: on which side it has the centre (+1 left: it turns left around it), or 0: it goes through
/// the point.
struct TangentEnd {
  Point centre;
  int side = 0;
};

/// The tangent in numbers. d leads from the first centre to the second, D = |d|^2, k = (side2 - side1) r, R = D - k^2.
/// The unit direction is (sqrt(R) d - k d') / D with d' = d turned left, its length sqrt(R). All products below are
/// scaled by D.
template <class Number>
struct TangentFrame {
  using Value = Surd<Number>;

  TangentFrame(const TangentEnd& from, const TangentEnd& to, double radius)
      : cx(meant<Number>(from.centre.x)),
        cy(meant<Number>(from.centre.y)),
        r(meant<Number>(radius)),
        s1(r * Number(double(from.side))),
        s2(r * Number(double(to.side))) {
    dx = meant<Number>(to.centre.x) - cx;
    dy = meant<Number>(to.centre.y) - cy;
    D = dx * dx + dy * dy;
    k = s2 - s1;
    R = D - k * k;
  }

  Number dot(const Number& x, const Number& y) const { return dx * x + dy * y; }
  Number cross(const Number& x, const Number& y) const { return dx * y - dy * x; }

  /// D times the position of w along the line, from the first tangent point.
  Value along(Point w) const {
    const Number x = meant<Number>(w.x) - cx, y = meant<Number>(w.y) - cy, q = cross(x, y);
    return {-(k * q), dot(x, y)};
  }
  /// D times what is left from w to the second tangent point, along the line.
  Value left_over(Point w) const {
    const Number x = meant<Number>(w.x) - cx, y = meant<Number>(w.y) - cy, q = cross(x, y);
    return {k * q, D - dot(x, y)};
  }
  /// D times how far w is to the left of the line, less `sides` radii.
  Value off(Point w, int sides) const {
    const Number x = meant<Number>(w.x) - cx, y = meant<Number>(w.y) - cy, p = dot(x, y);
    return {k * p + (s1 - Number(double(sides)) * r) * D, cross(x, y)};
  }
  /// D times (|w - T|^2 - r^2), T the first or the second tangent point.
  Value reach(Point w, bool second) const {
    Number x = meant<Number>(w.x) - cx, y = meant<Number>(w.y) - cy;
    if (second) {
      x = x - dx;
      y = y - dy;
    }
    const Number& s = second ? s2 : s1;
    const Number p = dot(x, y), q = cross(x, y), square = x * x + y * y;
    return {(square + s * s - r * r) * D + Number(2.0) * s * k * p, Number(2.0) * s * q};
  }
  /// D times f (T - w) with f = v - w: where T's foot is on the segment w v; with `from_end`, D (|f|^2 - f (T - w)).
  Value foot(Point w, Point v, bool second, bool from_end) const {
    const Number fx = meant<Number>(v.x) - meant<Number>(w.x), fy = meant<Number>(v.y) - meant<Number>(w.y);
    Number x = cx - meant<Number>(w.x), y = cy - meant<Number>(w.y);
    if (second) {
      x = x + dx;
      y = y + dy;
    }
    const Number& s = second ? s2 : s1;
    const Number a = D * (fx * x + fy * y) - s * k * dot(fx, fy), b = -(s * cross(fx, fy));
    if (!from_end) return {a, b};
    return {D * (fx * fx + fy * fy) - a, -b};
  }
  /// D times f x (T - w): on which side of the line w -> v the tangent point is.
  Value side(Point w, Point v, bool second) const {
    const Number fx = meant<Number>(v.x) - meant<Number>(w.x), fy = meant<Number>(v.y) - meant<Number>(w.y);
    Number x = cx - meant<Number>(w.x), y = cy - meant<Number>(w.y);
    if (second) {
      x = x + dx;
      y = y + dy;
    }
    const Number& s = second ? s2 : s1;
    const Number fd = fx * dy - fy * dx;
    return {D * (fx * y - fy * x) - s * k * fd, -(s * dot(fx, fy))};
  }
  /// D^2 |f|^2 times (distance of T from the line w v)^2 - r^2.
  Value beside(Point w, Point v, bool second) const {
    const Number fx = meant<Number>(v.x) - meant<Number>(w.x), fy = meant<Number>(v.y) - meant<Number>(w.y);
    const Value c = side(w, v, second);
    const Number limit = r * r * (fx * fx + fy * fy) * D * D;
    return {c.a * c.a + c.b * c.b * R - limit, Number(2.0) * c.a * c.b};
  }
  /// D times n f, n the line's unit left normal and f = v - w.
  Value across(Point w, Point v) const {
    const Number fx = meant<Number>(v.x) - meant<Number>(w.x), fy = meant<Number>(v.y) - meant<Number>(w.y);
    return {k * dot(fx, fy), cross(fx, fy)};
  }
  /// D times f x u, u the line's direction.
  Value turn(Point w, Point v) const {
    const Number fx = meant<Number>(v.x) - meant<Number>(w.x), fy = meant<Number>(v.y) - meant<Number>(w.y);
    return {-(k * dot(fx, fy)), -cross(fx, fy)};
  }

  /// D times f u.
  Value onward(Point w, Point v) const {
    const Number fx = meant<Number>(v.x) - meant<Number>(w.x), fy = meant<Number>(v.y) - meant<Number>(w.y);
    return {-(k * cross(fx, fy)), dot(fx, fy)};
  }

  Number cx, cy, r, s1, s2, dx, dy, D, k, R;
};

/// A straight leg between two circles of radius r (or points), tangent to both as their ends say. Every question is
/// answered exactly: an enclosure in doubles first, then a sign of a + b * sqrt(R) in rationals.
class TangentLine {
 public:
  /// Precondition: the centres differ.
  TangentLine(const TangentEnd& from, const TangentEnd& to, double r);

  /// Is there such a line? (Inner tangents need a distance >= 2r, a point one >= r.)
  bool exists() const { return exists_; }
  /// Does the segment w v start in the first circle's centre without coming nearer than r to the first tangent point;
  /// likewise the second's?
  bool clears_own(Point w, Point v, bool second) const;
  /// Is every point of the leg at least r away from the wall w v?
  bool clears(Point w, Point v) const;
  /// Does the leg go through the inside of the opening w v, beyond which (to its left or right) one must not be? Its
  /// ends are not asked.
  bool leaves_by(Point w, Point v, bool solid_left) const;

  int along(Point w) const;      ///< the sign of the position of w along the leg
  int left_over(Point w) const;  ///< the sign of what is left from w to the leg's end
  int off(Point w) const;        ///< +1: w is to the left of the line
  /// The sign of (v - w) x direction.
  int turn(Point w, Point v) const;
  /// The sign of (v - w) direction.
  int onward(Point w, Point v) const;

  Interval length() const { return S_; }
  /// Of all that is nearer than r to the part between two shares of the way from centre to centre, and a bit more.
  Box box(double from, double to) const;
  int pieces() const;  ///< into how many equal parts it is worth cutting for box()

 private:
  template <class Question>
  int decide(Question question) const;
  bool clears_end(Point w) const;
  bool tangent_point_clears(Point w, Point v, bool second) const;

  TangentEnd from_, to_;
  double r_;
  TangentFrame<Interval> frame_;
  Interval S_;
  bool exists_ = false;
  mutable std::unique_ptr<TangentFrame<Rational>> exact_;
};

}  // namespace taut
