// Who meets a target in the plane first: a point among obstacles, both as fast as they are, the target's way known.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/interval.h>
#include <taut/geometry/point.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/robots/fleet/fleet.h>

namespace taut::pursuit {

using fleet::TimedPoint;

/// A robot sets out from `start` at time 0, with `speed` at most. The target is there from its first time on, goes
/// straight and evenly from place to place, and is gone after its last time, or stays there for ever (`stays`).
struct Interception {
  Point start;
  double speed = 1;             ///< > 0
  std::vector<TimedPoint> way;  ///< not empty; times ascend strictly. Before time 0 nobody meets it
  bool stays = false;
};

/// Where they meet, as early as can be.
struct MeetingPlace {
  /// Two neighbouring doubles, or one: by `hi` robot and target can be at the same place, before `lo` and at it they
  /// cannot; they can at `hi` exactly where lo == hi.
  Interval time;
  Point at;                 ///< the target's place then, to rounding
  std::size_t leg = 0;      ///< of its way, from place number `leg` on
  std::vector<Point> path;  ///< the robot's, from the start to `at`; shortest
  double length = 0;        ///< of the path that ends exactly there, to rounding
  double waits = 0;         ///< how long the robot stands there before the target comes, to rounding
};

/// The earliest meeting; nothing when there is none, which is proven.
///
///  1. Robot and target meet where a path (docs/definitions.md, 2) of length speed * time leads from the start to the
///     target's place. Who is faster does not matter: a faster target can be met as it passes, also at one instant.
///  2. Numbers mean what was written (written.h). The last bend c of a path to the target on one of its legs makes the
///     equation D + |target(t) - c| = speed * t, D a sum of square roots: convex in t, at most a quadratic. All signs
///     that decide whether and where it has a root are exact (exact/signed_roots.h), as are the times at which c comes
///     into sight, which are rational. No cell of the shortest-path map is built: the least over all c in sight is the
///     distance.
///  3. Bends are taken from the graph, which has to be of the robot's space, by their exact distance.
/// Precondition: the start is free, and `blocked_leg` has nothing to say. After Dijkstra on the graph O(b c k) for b
/// bends that are nearer than the meeting, c cones that each sees, k legs.
std::optional<MeetingPlace> earliest_meeting(const VisibilityGraph& graph, const Interception& question);

/// The first leg of a way that does not lie in the space, by the place that it starts from; of a way of one place 0,
/// when that is not free.
std::optional<std::size_t> blocked_leg(const FreeSpace& space, std::span<const TimedPoint> way);

/// Where the target is at a time, to rounding; its first place before, its last one after.
Point place_at(std::span<const TimedPoint> way, double time);

}  // namespace taut::pursuit
