// From rings that are not simple to polygons that are.
#pragma once

#include <vector>

#include <taut/geometry/detail/polygon_validation.h>
#include <taut/geometry/point.h>

namespace taut::detail {

/// The closure of the places around which the outer ring winds an odd number of times and no hole does, as World
/// guarantees polygons; none when that is empty. Adds a flaw `crossing` when a ring winds around a place more than
/// once, `reach` when a hole lies beyond the outer ring or over another hole, `flat` when a ring has no area; each
/// unless there is one. Crossings are rounded to 15 digits. O((n + k) log n). Throws TooFine as node does.
/// Precondition: rings have at least 3 points.
std::vector<Polygon> mended(const Polygon& polygon, std::vector<Flaw>& flaws);

/// The closure of the places that an odd number of all these rings wind around, each counted as often as it does: any
/// rings, outer ones and holes alike. As mended else.
std::vector<Polygon> even_odd(const std::vector<Polygon>& polygons);

}  // namespace taut::detail
