// On which side of a line: orientation for places where three points in line are the usual case.
#pragma once

#include <taut/geometry/detail/root.h>
#include <taut/geometry/predicates.h>

namespace taut::detail {

/// The sign of two products, a b - c d, exactly. Precondition: neither overflows, underflow is noticed by the caller.
inline int compare_products(double a, double b, double c, double d) {
  const Pair left = two_product(a, b), right = two_product(c, d);
  if (left.high != right.high) return left.high > right.high ? 1 : -1;
  return (left.low > right.low) - (left.low < right.low);
}

/// What `orientation` gives, exactly. Differences that are doubles, as on every grid and near most points, never need
/// big numbers.
inline int side_of(Point a, Point b, Point c) {
  const double acx = a.x - c.x, bcy = b.y - c.y, acy = a.y - c.y, bcx = b.x - c.x;
  const double left = acx * bcy, right = acy * bcx, det = left - right;
  const double bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right)) + 1e-290;
  if (det > bound) return 1;
  if (-det > bound) return -1;
  if ((acx == 0 || bcy == 0) && (acy == 0 || bcx == 0)) return 0;
  const bool exact = two_sum(a.x, -c.x).low == 0 && two_sum(b.y, -c.y).low == 0 && two_sum(a.y, -c.y).low == 0 &&
                     two_sum(b.x, -c.x).low == 0;
  const auto is_moderate = [](double product) { return std::abs(product) > 1e-200; };
  if (exact && is_moderate(left) && is_moderate(right)) return compare_products(acx, bcy, acy, bcx);
  return exact_orientation(a, b, c);
}

}  // namespace taut::detail
