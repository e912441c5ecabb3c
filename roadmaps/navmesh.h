// A free space as convex polygons that meet at portals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut {

/// A navigation mesh: the free triangles merged into convex polygons, and where a path may go from one to the next.
/// Immutable.
///
///  1. A polygon is a run of corners, counter-clockwise; its interior angles are at most 180 degrees (vertices in line
///     are kept). The polygons' interiors are disjoint, their union is the free space.
///  2. The side of corner c runs from corners[c].point to the next corner's. It is a portal, unconstrained, when across
///     != kNone: `across` is the corner with the same side, the other way round, in the neighbour. Between two polygons
///     there may be several portals in line.
///  3. A bend is a reflex sector of the triangulation (see Triangulation): where a shortest path can turn.
///     corners[c].bend is the bend that this corner's angle is a part of.
///  4. Two portals are in one block iff a closed walk through both, without passing a polygon twice, exists
///     (biconnected components of the polygons' graph). A shortest path passes no block that it would have to leave
///     through the polygon it came from.
///
/// Polygons, corners, bends and blocks are numbered deterministically. Building takes O(n log n), a small part of what
/// the triangulation took; memory 32 bytes a corner. Merging is greedy, the longest sides first.
struct Navmesh {
  struct Corner {
    Point point;
    std::uint32_t across = kNone;
    std::uint32_t polygon = kNone;
    std::uint32_t bend = kNone;
    std::uint32_t block = kNone;  ///< of the portal that begins here; kNone when it is none
  };

  struct Bend {
    Point right;                         ///< the far end of the constraint that bounds the sector clockwise
    Point left;                          ///< likewise counter-clockwise
    std::uint32_t right_corner = kNone;  ///< the corner whose side runs along the right constraint
    std::uint32_t left_corner = kNone;   ///< the corner where the side before runs along the left constraint
    std::uint32_t sector = kNone;        ///< of the triangulation
  };

  /// How the blocks hang together: from any polygon up to a root of its component.
  struct BlockTree {
    std::vector<std::uint32_t> above;   ///< polygon -> the block towards the root, kNone at the root
    std::vector<std::uint32_t> depth;   ///< polygon -> how many blocks lie between it and the root
    std::vector<std::uint32_t> top;     ///< block -> its polygon nearest to the root
    std::vector<std::uint32_t> bridge;  ///< block -> a corner of its only portal, kNone when it has several
  };

  std::vector<Corner> corners;
  std::vector<std::uint32_t> first;       ///< polygon -> its first corner; one more entry than polygons
  std::vector<std::uint32_t> polygon_of;  ///< triangle -> polygon, kNone when it is not free
  std::vector<Bend> bends;
  BlockTree blocks;

  std::uint32_t polygon_count() const { return static_cast<std::uint32_t>(first.size() - 1); }
  std::span<const Corner> ring(std::uint32_t polygon) const {
    return {corners.data() + first[polygon], corners.data() + first[polygon + 1]};
  }
  std::uint32_t next(std::uint32_t c) const {
    const std::uint32_t p = corners[c].polygon;
    return c + 1 == first[p + 1] ? first[p] : c + 1;
  }
  std::uint32_t previous(std::uint32_t c) const {
    const std::uint32_t p = corners[c].polygon;
    return c == first[p] ? first[p + 1] - 1 : c - 1;
  }
};

/// The free triangles merged as above. O(n log n).
Navmesh navmesh(const FreeSpace& space);

/// The polygons are the free triangles themselves.
Navmesh triangle_navmesh(const FreeSpace& space);

/// The part of the mesh that a shortest path from `from` to the goal can pass: without the dead ends, whatever branches
/// off and holds neither end. For these ends only (of a room, all of it). In a maze with few loops a tenth of the work;
/// a side that leads into what was left out counts as none (across == kNone), and bends are bounded there too.
Navmesh navmesh_between(const FreeSpace& space, Point from, const Goal& to);

}  // namespace taut
