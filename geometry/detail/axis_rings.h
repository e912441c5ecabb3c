// Which polygons are surely in order. Private.
#pragma once

#include <taut/geometry/point.h>

namespace taut::detail {

/// Is the polygon one that admit() (polygon_validation.h) leaves as it is, but for the direction of its rings? True is
/// sure; false says nothing. Only of axis-parallel rings on integers below 2^30 it can be true. A line sweeps the
/// corners from below to above and knows the sides that it crosses: no two rings may share more than corners, and
/// everywhere the outer ring must wind around a place no less often than the holes. O(n log64 n).
bool is_surely_regular(const Polygon& polygon);

}  // namespace taut::detail
