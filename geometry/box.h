// Boxes around points, and their corners.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <taut/geometry/point.h>

namespace taut {

/// The smallest box that holds both points.
inline Box box_around(Point p, Point q) {
  return {{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}};
}

/// The smallest box that holds all points. Precondition: there is one.
inline Box box_around(std::span<const Point> points) {
  Box box{points.front(), points.front()};
  for (const Point p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
  }
  return box;
}

/// Holds every point within `margin` of the box.
inline Box widened(const Box& box, double margin) {
  const auto down = [margin](double v) { return std::nextafter(v - margin, -HUGE_VAL); };
  const auto up = [margin](double v) { return std::nextafter(v + margin, HUGE_VAL); };
  return {{down(box.min.x), down(box.min.y)}, {up(box.max.x), up(box.max.y)}};
}

/// Counter-clockwise from its least corner.
inline Ring ring_of(const Box& box) { return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}; }

}  // namespace taut
