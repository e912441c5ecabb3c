// The directed graph of a disc: tangent points, each passed in one of two directions around its circle. Private.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <taut/roadmaps/exact/tangent_parts.h>

namespace taut::detail {

/// A tangent point with the side that a path has its circle's centre on.
inline std::uint32_t arc_node(std::uint32_t point, int side) { return 2 * point + (side > 0); }

/// Walks the graph both ways; keeps the lengths of arcs.
class ArcWalk {
 public:
  explicit ArcWalk(const TangentParts& graph)
      : graph_(graph), arc_(graph.points.size(), Interval(std::numeric_limits<double>::quiet_NaN())) {}

  std::size_t nodes() const { return 2 * graph_.points.size(); }

  /// The same point, passed the other way.
  std::uint32_t turned(std::uint32_t n) const { return graph_.sites()[graph_.site_of[n / 2]].round ? n ^ 1 : n; }

  /// Calls visit(node, length) for all that follows n.
  template <class Visit>
  void onward(std::uint32_t n, Visit&& visit) {
    const std::uint32_t p = n / 2, site = graph_.site_of[p];
    const bool round = graph_.sites()[site].round;
    const int side = round ? (n % 2 == 1 ? 1 : -1) : 0;
    for (std::uint32_t i = graph_.first_leg[p]; i < graph_.first_leg[p + 1]; ++i)
      if (const TangentLeg& leg = graph_.legs[i]; leg.from_side == side)
        visit(arc_node(leg.to, leg.to_side), leg.length);
    if (!round || (side < 0 && p == graph_.first_point[site])) return;
    const std::uint32_t arc = side > 0 ? p : p - 1;
    if (graph_.arc_is_free[arc]) visit(arc_node(side > 0 ? p + 1 : p - 1, side), arc_length(arc));
  }

  /// Calls visit(node) for all that n follows.
  template <class Visit>
  void backward(std::uint32_t n, Visit&& visit) {
    onward(turned(n), [&](std::uint32_t m, const Interval&) { visit(turned(m)); });
  }

 private:
  /// From a point to the next one of its circle.
  const Interval& arc_length(std::uint32_t p) {
    if (std::isnan(arc_[p].lo)) arc_[p] = Interval(graph_.r) * angle_between(graph_.points[p], graph_.points[p + 1]);
    return arc_[p];
  }

  const TangentParts& graph_;
  std::vector<Interval> arc_;
};

}  // namespace taut::detail
