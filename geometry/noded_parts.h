// Corners wherever walls meet: what touches then shares a point, whatever is done to the points.
#pragma once

#include <span>

#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut {

/// The same walls and rings, with more corners on them. For whoever moves every corner by itself, as a projection does:
/// afterwards what touched still touches, as it shares a corner.
///
///  1. A wall without thickness, or a side of a ring, that is not parallel to an axis passes through every end of
///     another, and through each of `places`, start and goal, that lies on it by what the numbers mean. Exact. What is
///     parallel to an axis needs no corner as long as equal coordinates stay equal.
///  2. Where two cross, not both of them parallel to axes, both have a corner: the crossing, when it is a pair of
///     numbers, else rounded to 15 digits.
///  3. Walls with thickness stay whole: they cover what touches them.
/// Line numbers stay. O((n + k) log n), n walls and sides, k pairs whose boxes meet. Precondition: all coordinates are
/// valid.
WorldParts noded(WorldParts parts, std::span<const Point> places = {});

}  // namespace taut
