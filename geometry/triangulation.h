// The common index: a constrained Delaunay triangulation in flat arrays.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/point.h>

namespace taut {

inline constexpr std::uint32_t kNone = 0xffffffff;

/// A constrained Delaunay triangulation of the convex hull of its vertices, immutable once built.
///
///  1. Triangle t has the vertices triangles()[t][0..2], counter-clockwise; neighbours()[t][i] lies across the side
///     opposite to corner i, kNone outside the hull.
///  2. A side is constrained when an obstacle's boundary or a zero-thickness wall runs along it; no path crosses it.
///  3. A triangle is free when a path may be in it. A constrained side has at most a free triangle on each side (a
///     wall), or a free and a solid one (a boundary). Between a free and a solid triangle there is always a constrained
///     side.
///  4. A sector is a maximal fan of free triangles around a vertex, joined across unconstrained sides: what a path that
///     touches the vertex can turn in. sector_of()[3 * t + i] is the sector of corner i of the free triangle t, else
///     kNone.
struct Triangulation {
  using Triple = std::array<std::uint32_t, 3>;

  struct Sector {
    std::uint32_t vertex = kNone;
    std::uint32_t triangle = kNone;  ///< the clockwise-most triangle of the fan (any, when the fan is the full circle)
    std::uint32_t right = kNone;     ///< the far end of the constraint that bounds the fan clockwise; kNone when full
    std::uint32_t left = kNone;      ///< likewise counter-clockwise; at the free end of a wall right == left
    bool reflex = false;             ///< its angle exceeds 180 degrees: a path can bend here
    bool full = false;               ///< no constraint meets the vertex: the fan is the full circle
  };

  std::vector<Point> points;
  std::vector<Triple> triangles;
  std::vector<Triple> neighbours;
  std::vector<std::uint8_t> constrained;  ///< bit i of constrained[t]: the side opposite to corner i
  std::vector<std::uint8_t> free;         ///< 1 when triangle t is free
  std::vector<std::uint32_t> sector_of;   ///< 3 * t + i -> sector, kNone in solid triangles
  std::vector<Sector> sectors;            ///< ordered by vertex

  /// The points as integers below 2^29 over one unit (a power of ten or two) and counted from one corner, when what
  /// they mean is on such a lattice; else empty. Predicates on them fit an int64.
  std::vector<std::array<std::int32_t, 2>> lattice;

  bool is_constrained(std::uint32_t t, int i) const { return (constrained[t] >> i) & 1; }

  /// The sectors at vertex v, in order; the index of the first is `sectors_at(v).data() - sectors.data()`. O(log n).
  std::span<const Sector> sectors_at(std::uint32_t v) const {
    const auto [first, last] =
        std::equal_range(sectors.begin(), sectors.end(), Sector{v, kNone, kNone, kNone, false, false},
                         [](const Sector& a, const Sector& b) { return a.vertex < b.vertex; });
    return {std::to_address(first), std::to_address(last)};
  }

  /// Does the closed sector contain the direction from its vertex to q? Exact.
  bool looks_to(const Sector& sector, Point q) const;

  /// The corner of t's neighbour across side i that is not shared with t. Precondition: there is a neighbour.
  int mirror(std::uint32_t t, int i) const {
    const auto& back = neighbours[neighbours[t][i]];
    return back[0] == t ? 0 : back[1] == t ? 1 : 2;
  }
  /// The corner of t at vertex v. Precondition: there is one.
  int corner(std::uint32_t t, std::uint32_t v) const { return triangles[t][0] == v ? 0 : triangles[t][1] == v ? 1 : 2; }
  /// The next triangle counter-clockwise around corner i of t, across the side that bounds t there; kNone outside the
  /// hull.
  std::uint32_t ccw_triangle(std::uint32_t t, int i) const { return neighbours[t][ccw(i)]; }
  std::uint32_t cw_triangle(std::uint32_t t, int i) const { return neighbours[t][cw(i)]; }

  static int ccw(int i) { return i == 2 ? 0 : i + 1; }
  static int cw(int i) { return i == 0 ? 2 : i - 1; }
};

/// Calls visit(t, i) for the triangles of a sector, counter-clockwise; i is the corner of t at the sector's vertex.
template <class Visit>
void each_triangle(const Triangulation& tri, const Triangulation::Sector& sector, Visit&& visit) {
  std::uint32_t t = sector.triangle;
  do {
    const int i = tri.corner(t, sector.vertex);
    visit(t, i);
    if (tri.is_constrained(t, Triangulation::ccw(i))) return;
    t = tri.ccw_triangle(t, i);
  } while (t != sector.triangle);
}

}  // namespace taut
