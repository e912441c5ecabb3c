// How the ends of a query join a disc's graph. Private.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <taut/roadmaps/exact/tangent_parts.h>

namespace taut::detail {

/// A tangent point with the side that a path has its circle's centre on.
inline std::uint32_t arc_node(std::uint32_t point, int side) { return 2 * point + (side > 0); }

/// A node through which the goal is reached, and how far it is from there.
struct ArcExit {
  std::uint32_t node;
  Interval length;
  std::uint32_t leg;  ///< of the goal's
  bool by_arc;        ///< an arc before that leg
};

/// The tangent from an end to a circle, or to a corner of openings.
struct ArcEndLeg {
  std::uint32_t site = kNone;
  int side = 0;  ///< that a path from start to goal has the circle's centre on
  TangentPoint point;
  Interval length;
};

/// What a query adds to the graph.
struct ArcEnds {
  std::vector<ArcEndLeg> from_start, to_goal;
  std::vector<ArcExit> entries, exits;  ///< where they join the graph
  /// Ways that do not: straight, or along one circle.
  struct Apart {
    Interval length;
    std::uint32_t start_leg = kNone, goal_leg = kNone;  ///< kNone: straight
    bool by_arc = false;
  };
  std::vector<Apart> apart;
};

/// An end as a site that legs lead to: no circle, in the sector that FreeSpace::locate names.
TangentSite end_site(const TangentWalls& walls, Point p);

/// The graph that they join.
struct ArcGraph {
  /// Of a site: the number of the first, and all in order.
  struct Points {
    std::uint32_t first;
    std::span<const TangentPoint> all;
  };
  const TangentGround& ground;
  double r;
  std::function<Points(std::uint32_t site)> points_of;
};

/// Precondition: s and g are places of the disc, and not the same.
ArcEnds join_ends(const ArcGraph& graph, Point s, Point g);
ArcEnds join_ends(const TangentParts& graph, Point s, Point g);

}  // namespace taut::detail
