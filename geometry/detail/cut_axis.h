// Places along the side of a piece.
#pragma once

#include <CGAL/Interval_nt.h>

#include <cmath>
#include <optional>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/written.h>

namespace taut::detail {

inline bool axis_parallel(const Segment& s) { return s.a.x == s.b.x || s.a.y == s.b.y; }

/// A position on a directed line: a point with double coordinates, or where another line crosses.
struct Cut {
  Point point;  // the exact place unless `line` is set
  std::optional<Segment> line;
  double lo = 0, hi = 0;  // encloses the coordinate along the line
};

/// The side of a piece, as an axis for cuts.
class Axis {
 public:
  explicit Axis(const Segment& side)
      : side_(side),
        by_x_(std::abs(side.b.x - side.a.x) >= std::abs(side.b.y - side.a.y)),
        forward_(by_x_ ? side.a.x < side.b.x : side.a.y < side.b.y) {}

  Cut at(Point p) const {
    const Interval c = by_x_ ? written::enclosure(p.x) : written::enclosure(p.y);
    return {p, std::nullopt, forward_ ? c.lo : -c.hi, forward_ ? c.hi : -c.lo};
  }

  Cut crossing(const Segment& line) const {
    if (axis_parallel(side_) && axis_parallel(line))
      return at(side_.a.x == side_.b.x ? Point{side_.a.x, line.a.y} : Point{line.a.x, side_.a.y});
    using Number = CGAL::Interval_nt<true>;
    const auto number = [](double v) {
      const Interval i = written::enclosure(v);
      return Number(i.lo, i.hi);
    };
    const Number ax = number(side_.a.x), ay = number(side_.a.y), cx = number(line.a.x), cy = number(line.a.y);
    const Number sx = number(side_.b.x) - ax, sy = number(side_.b.y) - ay;
    const Number tx = number(line.b.x) - cx, ty = number(line.b.y) - cy;
    const Number along = ((cx - ax) * ty - (cy - ay) * tx) / (sx * ty - sy * tx);
    const Number c = by_x_ ? ax + along * sx : ay + along * sy;
    return {{}, line, forward_ ? c.inf() : -c.sup(), forward_ ? c.sup() : -c.inf()};
  }

  int compare(const Cut& c, const Cut& d) const {
    if (c.hi < d.lo) return -1;
    if (c.lo > d.hi) return 1;
    if (!c.line && !d.line)
      return forward_ ? order(coordinate(c.point), coordinate(d.point))
                      : order(coordinate(d.point), coordinate(c.point));
    const Rational difference = exact_coordinate(c) - exact_coordinate(d);
    return forward_ ? sgn(difference) : -sgn(difference);
  }

  ExactPoint exact(const Cut& c) const { return c.line ? line_crossing(side_, *c.line) : ExactPoint(c.point); }

 private:
  double coordinate(Point p) const { return by_x_ ? p.x : p.y; }
  static int order(double c, double d) { return (c > d) - (c < d); }
  Rational exact_coordinate(const Cut& c) const {
    const ExactPoint p = exact(c);
    return by_x_ ? p.x : p.y;
  }

  Segment side_;
  bool by_x_;
  bool forward_;
};

}  // namespace taut::detail
