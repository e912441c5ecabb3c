// The corridor of triangles that a path passes through.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut {

/// A sleeve in a triangulation: what there is of free space for a path that may be pulled, but not over an obstacle.
///
///  1. Each triangle but the first is a neighbour of the one before, across an unconstrained side (a portal).
///  2. No triangle is equal to the next but one: the corridor never turns back. It may pass a triangle several times,
///     as a path that winds around an obstacle does: a corridor is a walk, not a set.
///  3. `from` lies in the first triangle, `to` in the last one, sides and corners included.
struct Corridor {
  Point from, to;
  std::vector<std::uint32_t> triangles;  ///< at least one
};

/// The corridor of the path through these points; nothing when they are no path (a leg is blocked, slips through a
/// joint, an end is outside) or none at all. Two paths with the same ends have the same corridor, but for triangles
/// around the ends, iff one can be pulled into the other.
///
/// A path that runs along a zero-thickness wall stands for two when it could be on either side of it all the way. Then
/// the corridor is the one in which the fewest of its bends are loose (bends that could be pulled straight), so that a
/// taut path keeps its own; among equals the first in an order that only depends on the input. Exact. O(triangles
/// passed + triangles around the vertices touched).
std::optional<Corridor> corridor_of(const FreeSpace& space, std::span<const Point> points);

}  // namespace taut
