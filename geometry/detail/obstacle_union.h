// The outline of a union of convex pieces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/detail/noding.h>
#include <taut/geometry/point.h>

namespace taut::detail {

/// A convex polygon, strictly convex and counter-clockwise, and the wall it came from.
struct ConvexPiece {
  Ring ring;
  std::uint32_t wall = kNone;
};

struct Outline {
  std::vector<Edge> edges;    ///< turn 1: the solid to the left; collinear neighbours joined
  std::size_t crossings = 0;  ///< points constructed and rounded
  double displacement = 0;    ///< the largest distance of one from its exact place
};

/// The outline of the regularised union of `pieces`, as far as it lies in the box `within`.
///
/// Each side of each piece loses the parts that lie inside another piece, that another piece's side faces from the
/// other side, or that a piece of lower number shares; what remains is the outline. No arrangement is built. Positions
/// along a side are compared as doubles where they are ends or crossings of axis-parallel sides, else as intervals,
/// else as rationals; so right-angled worlds never meet a rational. Crossings are exact rationals, rounded to the free
/// side (round_outward_or_nearest), in units as fine as `within` allows. Outlines that bend there still pass
/// through those of the `fixed` points that lie on them. O(n log n + k log k) for k pairs of pieces whose boxes meet.
Outline outline_of_union(const std::vector<ConvexPiece>& pieces, const Box& within, std::span<const Point> fixed = {});

}  // namespace taut::detail
