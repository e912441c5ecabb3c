// The gate that every polygon passes before it enters a World.
#pragma once

#include <string>

#include <taut/geometry/point.h>

namespace taut::detail {

/// Brings a polygon with finite coordinates into the form World guarantees, or throws InputError(source, line, ...).
///
///  1. Repeated consecutive vertices are dropped, a repeated first vertex at the end too.
///  2. Each ring is simple: no two sides cross, overlap or touch, except neighbours at their common vertex. Vertices in
///     the middle of a straight side are fine, spikes (a side that folds back) are not.
///  3. Holes lie inside the outer ring and outside each other; rings may touch at points, not along sides.
///  4. The outer ring becomes counter-clockwise, holes clockwise.
/// All decisions are exact. O((n + k) log n) for n vertices and k pairs of sides whose boxes meet.
void admit(Polygon& polygon, const std::string& source, int line);

}  // namespace taut::detail
