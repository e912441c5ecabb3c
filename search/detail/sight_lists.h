// From which triangles a bend is seen so that a taut string can turn at it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/integer_places.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/detail/hub_graph.h>

namespace taut::detail {

/// The two sides of a bend: a string that arrives has the obstacle to its right and turns right, or to its left.
enum BendSide : std::uint32_t { kRightTurn = 0, kLeftTurn = 1 };

/// Bends as they are seen from within one triangle. From a place in it (closed) the bend is seen, and a string from the
/// place turns at it or goes on, iff the place lies neither to the right of the ray from the bend through `right` nor
/// to the left of that through `left`.
struct Sight {
  std::uint32_t bend = 0;       ///< 2 * vertex of the graph + BendSide
  std::uint32_t right = kNone;  ///< into places; kNone where the whole triangle lies within
  std::uint32_t left = kNone;
  std::uint32_t edges = 0;  ///< so many edges of the bend, from that side on, may follow; at most
};

/// A leg that is tangent at its one end and not at its other: a shortest path that ends there may use it.
struct HalfLegs {
  struct Leg {
    std::uint32_t to;
    double length;
  };
  std::vector<std::uint32_t> first;  ///< by 2 * vertex + BendSide where it begins tangent, into out
  std::vector<Leg> out;              ///< from the obstacle on, in the order in which they turn
  std::vector<std::uint32_t> in_first;
  std::vector<Leg> in;  ///< by the end that is not tangent: the other
};

/// All sights of a world on integer places, by triangle, those that need fewer tests first. O(triangles seen from each
/// bend).
struct SightLists {
  std::vector<IntegerPlaces::Place> places;  ///< ray_places
  std::vector<std::uint32_t> first;  ///< by triangle and number of tests: 4 a triangle (none; right; left; both)
  std::vector<Sight> sights;
  HalfLegs halves;
};

/// The vertices' places, then two for each bend: opposite to its sector's right side, and to its left one.
std::vector<IntegerPlaces::Place> ray_places(const VisibilityGraph& graph, const IntegerPlaces& places);

/// Nothing where there are more than `most` sights: on wide open ground every bend is seen from everywhere.
/// Preconditions: the graph is a reduced one, and all points of its triangulation are on `places`.
std::optional<SightLists> sight_lists(const VisibilityGraph& graph, const HubGraph& hubs, const IntegerPlaces& places,
                                      std::size_t most);

}  // namespace taut::detail
