// How often a path bends: the one definition that all planners' `corners` follow.
#pragma once

#include <cstddef>
#include <span>

#include <taut/geometry/point.h>

namespace taut {

/// The points between first and last at which a path bends, or turns back. Repeated points count once. With an
/// `uncertainty` of 0 a point that the path passes straight on is none, which is decided exactly, by what was written;
/// so paths along the same way have the same corners, however many points they are made of. Else those do not count
/// either that need not be there if every point lies within that distance of where it was meant: from the start, or a
/// point that counts, the path goes on to the last point up to which all lie within twice that distance of the straight
/// leg. O(n), with an uncertainty O(n k) for k points on a leg.
std::size_t corner_count(std::span<const Point> points, double uncertainty = 0);

}  // namespace taut
