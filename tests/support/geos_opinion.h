// What GEOS says of polygons, as a second opinion.
#pragma once

#include <vector>

#include <taut/geometry/point.h>

namespace taut::test {

/// The area of the faces that GEOSPolygonize makes of a ring's lines and that it winds around an odd number of times:
/// of those of the outer ring without those of the holes. Rings of at least 3 points, broken or not.
double geos_area(const Polygon& polygon);
/// The same of what GEOSMakeValid makes of each ring.
double geos_valid_area(const Polygon& polygon);

/// The area of the places in an odd number of the rings of these polygons.
double geos_even_odd_area(const std::vector<Polygon>& polygons);

/// Does `outer` cover `inner`, but for slivers of its arithmetic in doubles? Valid polygons.
bool geos_covers(const Polygon& outer, const Polygon& inner);

}  // namespace taut::test
