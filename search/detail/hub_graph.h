// What labels of hubs are made of: a graph whose edges turn, and prints of their lengths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <taut/geometry/exact/twofold.h>
#include <taut/geometry/integer_places.h>
#include <taut/geometry/point.h>
#include <taut/search/detail/taut_legs.h>

namespace taut::detail {

/// Edges of each vertex counter-clockwise by their first leg, from the obstacle's one side to its other, as TautLegs
/// has them.
struct HubGraph {
  struct Edge {
    double length;  ///< its high part
    std::uint32_t to;
    std::uint32_t right;  ///< so many edges of `to`, the first, turn right where this one arrives, or go straight on
    std::uint32_t left;   ///< those from this one on turn left, or go straight on
  };

  std::vector<std::uint32_t> first;  ///< by vertex, into edges
  std::vector<Edge> edges;
  std::vector<double> low;           ///< of the lengths
  std::vector<std::uint64_t> print;  ///< of the lengths, below
  std::vector<std::uint32_t> back;   ///< an edge the other way
  /// Appends the legs of an edge.
  std::function<void(const HubGraph&, std::uint32_t edge, std::vector<Segment>&)> legs;

  std::uint32_t size() const { return static_cast<std::uint32_t>(first.size() - 1); }
  twofold::Pair length(std::uint32_t e) const { return {edges[e].length, low[e]}; }
  /// Fills `back`.
  void find_backs();
};

/// Of all legs of a reduced visibility graph, which outlives it.
HubGraph hub_graph(const VisibilityGraph& graph, const TautLegs& legs, const IntegerPlaces* places);

/// A print of a sum of roots: equal sums of legs on integer places have equal prints (of legs elsewhere: when they have
/// the same legs), and prints of sums are sums of prints. Different sums that agree in their first 80 bits have the
/// same one by a chance of 2^-64.
std::uint64_t root_print(std::int64_t dx, std::int64_t dy);
std::uint64_t root_print(Point p, Point q);

/// A length on the way: the sum of two doubles, and its print.
struct PrintedLength {
  twofold::Pair sum;
  std::uint64_t print = 0;
};

/// Sums of up to 2^15 legs: those that differ by less than this part may be equal.
inline constexpr double kPairDoubt = 0x1p-80;

/// -1 when a is less, +1 when b is, 0 when they are equal; 2 when only roots can tell.
inline int compare(const PrintedLength& a, const PrintedLength& b) {
  const double difference = (a.sum.high - b.sum.high) + (a.sum.low - b.sum.low);
  if (difference > kPairDoubt * b.sum.high) return 1;
  if (difference < -kPairDoubt * b.sum.high) return -1;
  return a.print == b.print ? 0 : 2;
}

}  // namespace taut::detail
