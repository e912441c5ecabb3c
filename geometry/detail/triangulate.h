// From pieces that meet only at end points to the flat triangulation.
#pragma once

#include <span>

#include <taut/geometry/free_space.h>
#include <taut/geometry/triangulation.h>

namespace taut::detail {

/// A constrained Delaunay triangulation with its winding numbers, before free and solid are told apart.
struct Mesh {
  Triangulation triangulation;  ///< points, triangles, neighbours, constrained, lattice; the rest is empty
  /// piece_of[3 * t + i]: the piece along side i of triangle t, kNone when unconstrained.
  std::vector<std::uint32_t> piece_of;
};

/// Triangulates the convex hull of the pieces' ends; pieces become constrained sides. Precondition: they meet only at
/// end points. CGAL's constrained Delaunay triangulation; on lattices with predicates in int64 and int128, which decide the many cocircular
/// quadruples of a grid without multi-precision. Deterministic. O(n log n) expected.
Mesh triangulate(std::span<const Constraint> pieces);

/// Tells free from solid by the flags of the pieces and finds the sectors. Throws InputError when the flags contradict
/// each other (which noding excludes).
void classify(Mesh& mesh, std::span<const Constraint> pieces);

/// The scale that makes all coordinates integers below 2^29 in magnitude when multiplied by 2^scale; nothing when there is none.
std::optional<int> lattice_scale(std::span<const Point> points);

}  // namespace taut::detail
