// Splitting segments where they meet, so that what is left meets only at end points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/point.h>
#include <taut/geometry/triangulation.h>

namespace taut::detail {

/// A directed segment and what changes across it.
struct Edge {
  Point a;
  Point b;
  int turn = 0;                ///< winding number to the left minus to the right; 0: a wall
  std::uint32_t wall = kNone;  ///< the World wall it came from
};

/// Segments that meet only at end points, and what it took.
struct Noded {
  std::vector<Edge> edges;    ///< ordered by (a, b), a < b
  std::size_t crossings = 0;  ///< points constructed
  double displacement = 0;    ///< the largest distance of one from its exact place
};

/// Where a crossing that is no pair of doubles goes.
enum class Rounding {
  outward,  ///< of obstacles: to the nearest between walls, else to the side of lower winding numbers
  nearest,  ///< to the nearest
};

/// Splits edges wherever they cross, touch or overlap; of edges on one another the turns are added up.
///
/// A crossing is constructed exactly, then rounded to `unit` as `rounding` says. Rounding can make edges meet anew;
/// the splitting is repeated until nothing meets. An edge that bends at a rounded crossing still passes through those
/// of the `fixed` points that lie on it. Closed chains stay closed, so winding numbers stay defined. Walls on one
/// axis-parallel line are merged first into maximal runs.
/// O((n + k) log n), n edges with k contacts; all of them axis-parallel: O(n + k), see node_axis_parallel. Throws
/// TooFine when 32 rounds are not enough.
Noded node(std::vector<Edge> edges, const DecimalUnit& unit, std::span<const Point> fixed = {},
           Rounding rounding = Rounding::outward);

/// The same, axis-parallel or not: pairs of edges whose boxes meet, from an index of boxes.
Noded node_general(std::vector<Edge> edges, const DecimalUnit& unit, std::span<const Point> fixed = {},
                   Rounding rounding = Rounding::outward);

}  // namespace taut::detail
