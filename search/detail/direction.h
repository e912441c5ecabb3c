// Exact directions, compared by angle. Private.
#pragma once

#include <cstdint>

#include <taut/geometry/point.h>

namespace taut::detail {

/// Of to - from, turned left by `quarters` right angles. Exact for what the coordinates mean.
struct Direction {
  Point from;
  Point to;
  std::uint8_t quarters = 0;

  Direction opposite() const { return {from, to, static_cast<std::uint8_t>((quarters + 2) % 4)}; }
};

/// +1 when v lies less than 180 degrees to the left of u, 0 when they are parallel, -1 to the right.
int turn(const Direction& u, const Direction& v);

/// Does u come before v, counter-clockwise from the direction of x?
bool angle_less(const Direction& u, const Direction& v);

/// How (p - a)(b - a) compares to (q - a)(b - a): who is farther along.
int compare_along(Point a, Point b, Point p, Point q);

}  // namespace taut::detail
