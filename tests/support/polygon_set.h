// The general road to a union, as a second opinion: CGAL's Boolean sets.
#pragma once

#include <vector>

#include <taut/geometry/detail/obstacle_union.h>
#include <taut/geometry/point.h>

namespace taut::test {

/// What CGAL's Polygon_set_2 (exact constructions) says of the union of convex pieces within a box, and of polygons
/// that claim to be the rest of the box.
struct UnionOpinion {
  double free_area = 0;     ///< exact area of the box minus the union, to the nearest double
  double claimed_area = 0;  ///< exact area of the claimed polygons
  double stolen_area = 0;   ///< exact area of the claim that lies inside the union: 0 when obstacles never shrink
};

UnionOpinion opinion_of_cgal(const std::vector<detail::ConvexPiece>& pieces, const Box& within,
                             const std::vector<Polygon>& claimed);

}  // namespace taut::test
