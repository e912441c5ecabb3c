// A triangulation of axis-parallel edges on a lattice by one sweep. Private.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/triangulation.h>

namespace taut::detail {

/// A place on a lattice; differences of coordinates are below 2^30.
struct LatticePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

/// The edges that leave a vertex, by direction; kNone where none does.
struct AxisStar {
  std::uint32_t west = kNone, south = kNone, east = kNone, north = kNone;
};

/// A triangle in the making. Half-edge 3 * t + i is the side of triangle t opposite to its corner i.
struct RawTriangle {
  std::array<std::uint32_t, 3> corners;  ///< counter-clockwise
  std::array<std::uint32_t, 3> twins;    ///< the half-edge across each side; kNone on the hull
  std::array<std::uint32_t, 3> edges;    ///< the edge along each side; kNone when there is none
};

/// Triangulates the convex hull of the points, with all edges as sides.
///
/// A line sweeps the points from below to above, from left to right among equals (Hertel and Mehlhorn, "Fast
/// triangulation of the plane with respect to simple polygons", 1985). Between two vertical edges that it crosses
/// stands the upper rim of what is triangulated there, two chains that nothing sees into, which meet at the point that
/// came last; a new point is joined with all of the rim that it sees. No other points are made, and no triangle without
/// area. `points` are distinct and ordered by (y, x), `stars[v]` the edges at point v, of `edge_count` edges in all;
/// they meet only at points. O(n log64 n).
std::vector<RawTriangle> sweep(std::span<const LatticePoint> points, std::span<const AxisStar> stars,
                               std::size_t edge_count);

/// Turns sides that are no edges until the triangulation is constrained Delaunay: no circle around a triangle has the
/// corner across one of its free sides inside (Lawson). Exact: int64 where the triangles are small, int128 elsewhere.
/// False, and nothing but a valid triangulation, when more than `limit` sides had to be turned.
bool make_delaunay(std::vector<RawTriangle>& mesh, std::span<const LatticePoint> points, std::size_t limit);

}  // namespace taut::detail
