// How often a path bends: the one definition that all planners' `corners` follow.
#pragma once

#include <cstddef>
#include <span>

#include <taut/geometry/point.h>

namespace taut {

/// The points where the chain bends, or turns back. Repeated points count once; a point that it passes straight on is
/// none, which is decided exactly, by what was written. So paths along the same way have the same corners, however many
/// points they are made of. O(n).
std::size_t corner_count(std::span<const Point> chain);

}  // namespace taut
