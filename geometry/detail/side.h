// On which side of a line: orientation for places where three points in line are the usual case.
#pragma once

#include <taut/geometry/written.h>

namespace taut::detail {

/// What `written::orientation` gives, exactly. Right angles never need big numbers.
inline int side_of(Point a, Point b, Point c) {
  if (const int quick = written::detail::quick_orientation(a, b, c); quick != 0) return quick;
  if ((a.x == c.x || b.y == c.y) && (a.y == c.y || b.x == c.x)) return 0;
  return written::detail::exact_orientation(a, b, c);
}

}  // namespace taut::detail
