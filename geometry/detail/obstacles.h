// What a robot's reference point must keep out of, as convex pieces.
#pragma once

#include <span>
#include <vector>

#include <taut/geometry/detail/obstacle_union.h>
#include <taut/geometry/footprint.h>
#include <taut/geometry/world.h>

namespace taut::detail {

/// Convex pieces that together cover exactly the obstacles of `world` for `footprint`, or a little more.
struct Obstacles {
  std::vector<ConvexPiece> pieces;
  /// How far a piece reaches at most beyond the exact one; 0 when every corner is a pair of doubles.
  double excess = 0;
};

/// Solids are cut into triangles unless convex; what lies outside the areas is cut into triangles out to a frame around
/// `box()`; walls with a thickness are rectangles; each is Minkowski-summed with the reflected footprint. With a point,
/// zero-thickness walls are left to the noding; with any other footprint they become pieces. Corners that are no pair
/// of doubles are moved outwards: the piece is widened by `excess` before rounding. Outlines keep the `fixed` points
/// on them, as in node(). O(n log n).
Obstacles obstacles_of(const World& world, const Footprint& footprint, std::span<const Point> fixed = {});

/// The same for a point, without what the rings of polygons say themselves (winding numbers settle their overlaps): the
/// walls with a thickness and, where there are any or several areas, which may overlap, what lies outside of the areas.
/// No pieces: the ring of the one area says that, too.
Obstacles obstacles_beside_rings(const World& world, std::span<const Point> fixed = {});

/// The convex hull, strictly convex and counter-clockwise. Exact. O(n log n).
Ring convex_hull(std::vector<Point> points);

}  // namespace taut::detail
