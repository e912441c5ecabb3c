// The gate that every polygon passes before it enters a World.
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/mend_rings.h>
#include <taut/geometry/point.h>

namespace taut::detail {

/// What is not in order with a polygon, and where.
struct Flaw {
  enum Kind {
    repeat,    ///< a point twice in a row
    flat,      ///< a ring without area
    spike,     ///< a side that folds back over the one before
    touch,     ///< a ring that comes back to one of its points
    overlap,   ///< a ring that runs along itself
    along,     ///< a hole that shares a stretch with the outer ring or another hole
    crossing,  ///< a ring that crosses itself, or winds around a place twice
    reach,     ///< a hole that reaches over the outer ring or another hole
  };
  Kind kind;
  std::string message;

  /// May one mean more than one thing by it?
  bool is_ambiguous() const { return kind == crossing || kind == reach; }
};

/// The polygons that `polygon`, with finite coordinates, means, each in the form World guarantees:
///
///  1. Each ring is simple: no two sides cross, overlap or touch, except neighbours at their common vertex; no vertex
///     repeats. Vertices in the middle of a straight side are fine.
///  2. Holes lie inside the outer ring and outside each other; rings may touch at points, not along sides.
///  3. The outer ring is counter-clockwise, holes clockwise.
///
/// A polygon that is so keeps its vertices in their order. Any other means the closure of the places around which its
/// outer ring winds an odd number of times, and none of its holes: stretches without width go, a hole that cuts it in
/// two leaves two. Its flaws are appended, the first of each kind; where one is ambiguous the polygons mean nothing
/// unless `crossings` is even_odd. Nothing but crossings is rounded, all decisions are exact. O((n + k) log n) for n
/// vertices and k pairs of sides whose boxes meet.
std::vector<Polygon> admit(Polygon polygon, std::vector<Flaw>& flaws, Crossings crossings = Crossings::refuse);

}  // namespace taut::detail
