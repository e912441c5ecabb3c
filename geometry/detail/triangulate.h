// From edges that meet only at end points to the flat triangulation.
#pragma once

#include <optional>
#include <span>

#include <taut/geometry/detail/noding.h>
#include <taut/geometry/triangulation.h>

namespace taut::detail {

/// A constrained Delaunay triangulation before free and solid are told apart.
struct Mesh {
  Triangulation triangulation;  ///< points, triangles, neighbours, constrained, lattice; the rest is empty
  /// edge_of[3 * t + i]: the edge along side i of triangle t, kNone when unconstrained.
  std::vector<std::uint32_t> edge_of;
};

/// Triangulates the convex hull of the edges' ends; edges become constrained sides. Precondition: they meet only at
/// end points. A constrained Delaunay triangulation of what the points mean, points along a Hilbert curve, triangles in
/// the order of their points. Deterministic. Axis-parallel edges on a lattice by triangulate_axis_parallel, else
/// triangulate_general.
Mesh triangulate(std::span<const Edge> edges);

/// The same by CGAL's constrained Delaunay triangulation; on lattices with predicates in int64 and int128, which decide
/// the many cocircular quadruples of a grid without multi-precision. O(n log n) expected.
Mesh triangulate_general(std::span<const Edge> edges);

/// The same by one sweep and turned sides (axis_sweep.h); nothing when an edge is not axis-parallel, when the ends are
/// on no lattice (lattice_places), or when more sides had to be turned than pays. Of points on a circle it may choose
/// others. O(n), and as many turns.
std::optional<Mesh> triangulate_axis_parallel(std::span<const Edge> edges);

/// Does the edge along side i of t, whose a < b, have t to its left? Else t lies to its right.
inline bool is_left_of_edge(const Triangulation& tri, std::uint32_t t, int i) {
  return tri.points[tri.triangles[t][Triangulation::ccw(i)]] < tri.points[tri.triangles[t][Triangulation::cw(i)]];
}

/// The winding number of each triangle: `outside` beyond the hull, and it changes by an edge's turn across it.
/// Precondition: a < b of each edge, and their turns form closed chains (std::logic_error otherwise). O(n).
std::vector<int> winding_numbers(const Mesh& mesh, std::span<const Edge> edges, int outside);

/// Tells free from solid: outside the hull the winding number is 1, it changes by an edge's turn across it, and a
/// triangle is free where it is 0. Finds the sectors. Precondition: as above.
void classify(Mesh& mesh, std::span<const Edge> edges);

/// The points as integers of magnitude below 2^29 over one unit: a power of two, counted from the origin, or a power of
/// ten, counted from the least coordinates. Empty when they are not on such a lattice.
std::vector<Point> lattice_places(std::span<const Point> points);

}  // namespace taut::detail
