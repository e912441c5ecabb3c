// The free triangles' outline as polygons with holes.
#pragma once

#include <vector>

#include <taut/geometry/point.h>
#include <taut/geometry/triangulation.h>

namespace taut::detail {

/// The closure of the free triangles as polygons with holes: interiors are disjoint and connected, rings are simple
/// (one that would touch itself is split there), collinear vertices are dropped; outer rings counter-clockwise, holes
/// clockwise, each from its smallest vertex on, everything sorted. Zero-thickness walls leave no trace. O(n log n).
std::vector<Polygon> outline_rings(const Triangulation& tri);

}  // namespace taut::detail
