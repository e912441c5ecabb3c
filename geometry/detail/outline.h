// Which parts of an outline have no wall on them.
#pragma once

#include <vector>

#include <taut/geometry/world.h>

namespace taut::detail {

/// The sides of all rings of these areas, ring by ring, consecutive sides of one line joined into one.
/// Precondition: the areas are admitted polygons.
std::vector<Segment> outline(const std::vector<Area>& areas);
/// Of one polygon; its inside lies to the left of each side.
std::vector<Segment> outline(const Polygon& polygon);

/// The maximal pieces of `sides`, in order and direction, on which no wall stands. Walls count by their centre line,
/// whatever their thickness. With `seams`, a piece along which another side runs the other way is no outline and left
/// out too. A wall counts when it is exactly collinear with the side. O((n + k) log n).
std::vector<Segment> open_pieces(const std::vector<Segment>& sides, const std::vector<Wall>& walls, bool seams);

}  // namespace taut::detail
