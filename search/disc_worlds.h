// Worlds of points that bound what a disc can do.
#pragma once

#include <cstddef>
#include <optional>

#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut {

/// The plain world (plain_world.h) that proofs about a disc's arcs are made of: `world`, where that is plain; else the
/// polygons of its free space, its limits being walls (walled_world.h).
World disc_ground(const World& world, Point start, Point goal);

/// In which a point may go wherever the centre of a disc of radius r may: the areas and solids of `ground`, and around
/// each of its pieces the hull of two polygons, whose corners lie nearer than r to its ends. So does all of the hull,
/// to the piece; so what keeps r from all pieces meets none of the hulls. They overlap; what of them lies in others is
/// left out. Polygons have 64 corners, 32 where there are more than kManyPieces. Corners are decimals. Nothing where
/// 42 bits do not hold coordinates that fine. Throws InputError as LatticeIntegers does. Preconditions: ground is
/// plain, r > 0.
std::optional<World> inner_world(const World& ground, double r);

inline constexpr std::size_t kManyPieces = 2000;

/// The walls and solids of `ground` and nothing else that a disc keeps its radius from: limits that are no walls are
/// replaced by a box so wide that no path from one place of ground to another is near to it.
World bare_world(const World& ground, double r);

}  // namespace taut
