// Where a disc turns: circles around the corners of walls, and the legs that touch two of them.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include <taut/geometry/free_space.h>
#include <taut/geometry/progress.h>

namespace taut {

struct TangentParts;

/// The visibility graph of a disc: what a shortest path of its centre consists of, given that it keeps a distance >= r
/// from every wall.
///
///  1. Walls and openings are those of Gates, guarantee 1: the centre keeps its distance from walls, not from openings,
///     which it may touch and run along, not cross. r is that double, not a polygon around it. A corridor exactly 2r
///     wide is passable.
///  2. Vertices are tangent points on circles of radius r around corners where a path can bend: ends of walls all of
///     whose walls lie in an open half-plane, seen from a free side. Where only openings meet at a reflex corner the
///     circle is the corner itself.
///  3. Edges are the common tangents (two outer, two inner) that keep the distance from every wall and cross no
///     opening, and the arcs between neighbouring tangent points of one circle that do. A path keeps to one direction
///     around a circle: it arrives by a tangent, follows arcs and leaves by a tangent without a kink.
///  4. Exact: whether a leg or an arc is free, the order of tangent points around a circle, and which of them are one.
///     A tangent point lies in a field with one square root, so each question is the sign of a + b sqrt(c), or with two
///     roots for the order: enclosed in doubles first, decided in rationals when the enclosure cannot tell. In grids,
///     where circles and walls touch exactly, it often cannot.
///  5. It holds a shortest path between any two places, with legs from the ends added (arc_search).
///  6. Same space and radius, same graph.
/// Candidates are the pairs of corners that see each other within each other's taut cones, widened by 2r, by triangular
/// expansion that follows only what shows some of them; walls near a leg come from an R-tree. O(k log n) for k such
/// pairs on worlds whose walls are spread evenly. 45 x 45 cells:
/// bench/tangent_graph_bench.cpp.
/// Source: Liu and Arimoto, "Path planning using a tangent graph for mobile robots among polygonal and curved
/// obstacles" (1992), without the exact decisions.
/// Preconditions: the space's footprint is Footprint::point(); 0 < r <= World::kLargest.
class TangentGraph {
 public:
  /// Told are the circles whose legs are found.
  TangentGraph(const FreeSpace& space, double r, const TellProgress& tell = {});
  explicit TangentGraph(std::shared_ptr<const TangentParts> parts) : parts_(std::move(parts)) {}

  const FreeSpace& space() const;
  double radius() const;

  std::size_t corner_count() const;  ///< circles and corners of openings
  std::size_t point_count() const;   ///< tangent points
  std::size_t leg_count() const;     ///< free tangents, each counted once
  std::size_t arc_count() const;     ///< free arcs between neighbouring tangent points

  /// Circles, tangent points and legs, for searches (roadmaps/exact/tangent_parts.h).
  const TangentParts& parts() const { return *parts_; }

 private:
  std::shared_ptr<const TangentParts> parts_;
};

}  // namespace taut
