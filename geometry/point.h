// Plain values of the plane. A coordinate is a double and means exactly that number.
#pragma once

#include <compare>
#include <vector>

namespace taut {

/// A point. x to the right, y up; the unit is whatever the input file uses.
struct Point {
  double x = 0;
  double y = 0;

  /// Lexicographic, x first. Coordinates in a World are finite, so the order is total there.
  friend auto operator<=>(const Point&, const Point&) = default;
};

/// Closed; from a to b where a direction matters. a == b is a single point.
struct Segment {
  Point a;
  Point b;

  friend bool operator==(const Segment&, const Segment&) = default;
};

/// A closed axis-parallel rectangle, min.x <= max.x and min.y <= max.y.
struct Box {
  Point min;
  Point max;

  friend bool operator==(const Box&, const Box&) = default;

  bool contains(Point p) const { return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y; }
};

/// A closed chain of at least three vertices; the first is not repeated at the end.
using Ring = std::vector<Point>;

/// A closed region: inside `outer`, outside the interiors of `holes`.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;

  friend bool operator==(const Polygon&, const Polygon&) = default;
};

}  // namespace taut
