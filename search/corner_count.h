// How often a path bends.
#pragma once

#include <cstddef>
#include <span>

#include <taut/geometry/point.h>

namespace taut {

/// The number of points between first and last at which a path bends. Exact with an `uncertainty` of 0: points that it
/// passes straight do not count. Else those do not count either that need not be there if every point lies within that
/// distance of where it was meant: from the start, or a point that counts, the path goes on to the last point up to
/// which all lie within twice that distance of the straight leg. O(n k), k points on a leg.
std::size_t corner_count(std::span<const Point> points, double uncertainty = 0);

}  // namespace taut
