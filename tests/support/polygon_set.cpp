#include "support/polygon_set.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

namespace taut::test {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Ring2 = CGAL::Polygon_2<Kernel>;
using Polygon2 = CGAL::Polygon_with_holes_2<Kernel>;
using Set = CGAL::Polygon_set_2<Kernel>;

Ring2 ring_of(const Ring& ring) {
  Ring2 result;
  for (const Point p : ring) result.push_back({p.x, p.y});
  return result;
}

double area(const Set& set) {
  std::vector<Polygon2> polygons;
  set.polygons_with_holes(std::back_inserter(polygons));
  Kernel::FT sum = 0;
  for (const Polygon2& p : polygons) {
    sum += p.outer_boundary().area();
    for (const auto& hole : p.holes()) sum += hole.area();
  }
  return CGAL::to_double(sum);
}

}  // namespace

UnionOpinion opinion_of_cgal(const std::vector<detail::ConvexPiece>& pieces, const Box& within,
                             const std::vector<Polygon>& claimed) {
  std::vector<Ring2> rings;
  for (const auto& piece : pieces) rings.push_back(ring_of(piece.ring));
  Set solid;
  solid.join(rings.begin(), rings.end());
  Set rest(ring_of({within.min, {within.max.x, within.min.y}, within.max, {within.min.x, within.max.y}}));
  rest.difference(solid);
  Set claim;
  for (const Polygon& p : claimed) {
    Polygon2 polygon(ring_of(p.outer));
    for (const Ring& hole : p.holes) polygon.add_hole(ring_of(hole));
    claim.join(polygon);
  }
  Set stolen(claim);
  stolen.intersection(solid);
  return {area(rest), area(claim), area(stolen)};
}

}  // namespace taut::test
