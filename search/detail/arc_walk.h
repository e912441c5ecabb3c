// The directed graph of a disc: tangent points, each passed in one of two directions around its circle. Private.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <taut/search/detail/arc_ends.h>
#include <taut/search/detail/arc_hierarchy.h>

namespace taut::detail {

/// Walks the graph both ways; keeps the lengths of arcs.
class ArcWalk {
 public:
  explicit ArcWalk(const TangentParts& graph)
      : graph_(graph), arc_(graph.points.size(), Interval(std::numeric_limits<double>::quiet_NaN())) {}

  std::size_t nodes() const { return 2 * graph_.points.size(); }
  double radius() const { return graph_.r; }
  const TangentPoint& point(std::uint32_t p) const { return graph_.points[p]; }
  std::uint32_t site_of(std::uint32_t p) const { return graph_.site_of[p]; }
  const TangentSite& site(std::uint32_t i) const { return graph_.sites()[i]; }

  ArcEnds join(Point s, Point g) const { return join_ends(graph_, s, g); }

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

 private:
  /// From a point to the next one of its circle.
  const Interval& arc_length(std::uint32_t p) {
    if (std::isnan(arc_[p].lo)) arc_[p] = Interval(graph_.r) * angle_between(graph_.points[p], graph_.points[p + 1]);
    return arc_[p];
  }

  const TangentParts& graph_;
  std::vector<Interval> arc_;
};

/// What a hierarchy is made of. Arcs are so many times as long.
inline TurnableGraph turnable(ArcWalk& walk, double arcs = 1) {
  TurnableGraph result;
  result.first.push_back(0);
  for (std::uint32_t n = 0; n < walk.nodes(); ++n) {
    result.turned.push_back(walk.turned(n));
    // A corner of openings has one node for both ways.
    if (n % 2 == 0 || walk.turned(n) != n)
      walk.onward(n, [&](std::uint32_t m, const Interval& length) {
        const bool is_arc = walk.site_of(n / 2) == walk.site_of(m / 2);
        result.edges.push_back({m, (is_arc ? arcs : 1) * length.middle()});
      });
    result.first.push_back(static_cast<std::uint32_t>(result.edges.size()));
  }
  return result;
}

}  // namespace taut::detail
