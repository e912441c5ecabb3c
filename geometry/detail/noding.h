// Splitting segments where they meet, so that what is left meets only at end points.
#pragma once

#include <cstddef>
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut::detail {

/// Segments that meet only at end points, and what it took.
struct Noded {
  std::vector<Constraint> pieces;  ///< ordered by (a, b)
  std::size_t crossings = 0;       ///< points constructed
  double displacement = 0;         ///< the largest distance of one from its exact place
};

/// Splits walls and outlines wherever they cross, touch or overlap; pieces on one another become one (an outline
/// wins over a wall, two outlines with their solids on both sides vanish).
///
/// A crossing is constructed exactly, then rounded: to the nearest doubles between walls, to the free side of an
/// outline. Rounding can make pieces meet anew; the splitting is repeated until nothing meets. Walls on one axis-parallel
/// line are merged first into maximal runs. O((n + k) log n), n segments with k contacts.
/// Throws InputError when 32 rounds are not enough.
Noded node(std::vector<Constraint> segments);

}  // namespace taut::detail
