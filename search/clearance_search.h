// Paths that keep away from the walls: on the Voronoi diagram, with the wall pairs that decide named.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <taut/roadmaps/voronoi.h>

namespace taut {

/// Where a path is narrowest.
struct Pinch {
  enum class Where { gate, start, goal };

  Where where = Where::gate;
  double clearance = 0;  ///< to the nearest double
  std::array<std::uint32_t, 2> constraints{kNone,
                                           kNone};  ///< the two walls; at an end of the path its nearest, and kNone
  /// The gate: the nearest points of the two walls; at an end of the path the wall's and the end itself
  std::array<Point, 2> posts{};
};

/// A path along the diagram: from the start straight away from its nearest wall, along edges, and likewise to the goal.
struct ClearancePath {
  /// chained; none when start and goal are one point. sampled() makes points of them
  std::vector<Bezier> curves;
  double length = 0;         ///< to about 1e-13 of itself
  Pinch pinch;               ///< of several equally narrow places the first
  std::size_t expanded = 0;  ///< places the search took from its queue for good
};

/// The disc a robot may be at most, against the way it then has to go.
struct ClearanceTrade {
  /// == path.pinch.clearance: the path serves all discs up to this radius (and is the shortest for those above the
  /// previous entry's)
  double clearance = 0;
  ClearancePath path;
};

/// Queries between two points of a diagram. Shortest is meant among ways along the diagram, not in the plane. Lengths
/// are compared as doubles, clearances exactly: against c, against each other, and at the ends.
///
/// Why the widest way along the diagram is the widest of all: moving every point of a path straight away from its
/// nearest wall until it meets the diagram is continuous and never lowers clearance, so a path with clearance c at all
/// becomes one along the diagram with the same ends' legs and clearance >= c.
/// Precondition: start and goal are not outside; they may touch walls (clearance 0). Build O(V + E); each search O((V +
/// E) log V).
class ClearanceSearch {
 public:
  ClearanceSearch(VoronoiRoadmap roadmap, Point start, Point goal);

  /// The shortest way with clearance >= c >= 0; nothing when there is none, neither here nor anywhere else in free
  /// space.
  std::optional<ClearancePath> shortest(double c) const;
  /// The way with the largest clearance, and of these the shortest: the largest disc that gets through. Nothing when
  /// not connected.
  std::optional<ClearancePath> widest() const;
  /// The Pareto front of length and clearance, from the shortest to the widest: clearance and length both strictly
  /// increase (the length may repeat when rounding hides the difference). A search for each entry, after which `told`
  /// gets it.
  std::vector<ClearanceTrade> tradeoff(const std::function<void(const ClearanceTrade&)>& told = {}) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace taut
