// On which side of a line: orientation for places where three points in line are the usual case.
#pragma once

#include <cmath>

#include <taut/geometry/written.h>

namespace taut::detail {

/// What `written::orientation` gives, exactly. Right angles never need big numbers.
inline int side_of(Point a, Point b, Point c) {
  const double acx = a.x - c.x, bcy = b.y - c.y, acy = a.y - c.y, bcx = b.x - c.x;
  const double det = acx * bcy - acy * bcx;
  const double reach = std::abs(acx) + std::abs(bcy) + std::abs(acy) + std::abs(bcx);
  const double bound = 9e-16 * reach * (reach + std::abs(c.x) + std::abs(c.y)) + 1e-290;
  if (det > bound) return 1;
  if (-det > bound) return -1;
  if ((acx == 0 || bcy == 0) && (acy == 0 || bcx == 0)) return 0;
  return written::detail::exact_orientation(a, b, c);
}

}  // namespace taut::detail
