// How far it is at least to a goal, around the walls. Private.
#pragma once

#include <memory>
#include <vector>

#include <taut/geometry/world.h>
#include <taut/roadmaps/visibility_graph.h>

namespace taut::car::detail {

/// Shortest ways of a regular 16-gon inside a disc of this radius (0: of a point): no shorter than its rounding, and no
/// longer than the way of anything that has the disc in it. Each position costs one visibility expansion.
class Geodesic {
 public:
  Geodesic(const World& world, double radius, const std::vector<Point>& goals);

  /// A lower bound of the length of the reference point's way from p to the nearest goal; infinite when there is none,
  /// or p is no place for the disc.
  double from(Point p) const;

 private:
  std::unique_ptr<const VisibilityGraph> graph_;
  std::vector<Point> goals_;
  std::vector<double> length_;  ///< of the graph's vertices
};

}  // namespace taut::car::detail
