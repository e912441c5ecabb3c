// One pass of joining. Private: snap.h says what it does.
#pragma once

#include <span>

#include <taut/geometry/snap.h>

namespace taut::detail {

/// What may be joined.
struct Joining {
  double rounding = 0;          ///< ends and walls so near, with a computed number among their ends
  double reach = 0;             ///< walls so near, whatever their numbers
  bool polygons_apart = false;  ///< no contact of a polygon with itself
};

/// Precondition: all coordinates are valid.
SnappedParts joined(WorldParts parts, const Joining& joining, std::span<const Point> ends);

}  // namespace taut::detail
