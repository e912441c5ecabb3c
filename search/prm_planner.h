// A path by a probabilistic roadmap that grows until it finds one.
#pragma once

#include <cstddef>
#include <functional>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/prm.h>
#include <taut/search/graph_search.h>

namespace taut {

/// What has been done so far.
struct PrmProgress {
  PrmCounts counts;  ///< in lazy growth edges are counted when they have been tested
  double seconds = 0;
};

/// How a roadmap is grown and when to give up.
struct PrmPlan {
  /// `samples` is how many are drawn at most; absent: a million. A lattice is drawn whole first, then at half the
  /// spacing, and so on.
  PrmOptions roadmap{};
  /// Test an edge only when a candidate for the shortest path uses it.
  bool lazy = false;
  bool exactly = false;  ///< all samples are drawn before it is asked whether the ends are joined
  /// >= 0. Once a path is found that many times as many samples are drawn again (within `samples`), those near the path
  /// alone are kept, and a path is searched once more: where it goes the roadmap is as dense as one of all these
  /// samples, at a part of the cost. Where that path were longer (its ends being joined to other vertices), none are
  /// kept.
  double refine = 0;
  double seconds = 1e300;  ///< looked at after each batch of samples; a batch adds 64 or a sixteenth of what there is
  GraphAlgorithm algorithm = GraphAlgorithm::astar;
  /// Called after each batch; false ends the search.
  std::function<bool(const PrmProgress&)> progress{};
};

/// How far a roadmap hangs together.
struct PrmConnectivity {
  PrmCounts counts;
  std::size_t start_part = 0;  ///< vertices that hang together with the start
  std::size_t goal_part = 0;   ///< with the goal, of a room any of its boxes
};

/// The answer, the roadmap it came from, and how far that hangs together.
struct PrmResult {
  /// found: the path is the shortest in the roadmap as it was then, not in the world. none: start and goal lie in
  /// different components of the space, which proves that there is no path at all (nothing is sampled). stopped: the
  /// budget ended first; proves nothing.
  GraphSearchResult search;
  Roadmap roadmap;  ///< of the edges that were tested and found free
  PrmCounts counts;
  std::size_t start_part = 0, goal_part = 0;  ///< as in PrmConnectivity
  double coverage = 0;  ///< share of the vertices that hang together with the start or the goal, 0 .. 1
  double seconds = 0;

  PrmConnectivity connectivity() const { return {counts, start_part, goal_part}; }
};

/// Grows a PRM batch by batch until it joins `from` and the goal.
///
///  1. Every leg of the path is clear as in PrmOptions, guarantee 1; the first and the last one as in
///     nearest_visible().
///  2. Both ends are joined to their 8 nearest visible vertices; straight to each other if they see each other.
///  3. A room is reached when the path is in the middle of one of its boxes; boxes whose middle is not free are no
///     goals.
///  4. Lazy or not, the same samples are drawn and the path found has the same length (with `refine`, unless it is as
///     long as another one, around which others would be kept). Lazy: A* in doubles tests an
///     edge when it takes it from its queue (Cohen, Phillips, Likhachev 2014); then the exact search runs on what is
///     not known to be blocked, and every edge of its answer is tested, until all are free (lazy PRM: Bohlin, Kavraki
///     2000). With Rules visible and forest growth can't be lazy: they are Rule::nearest then.
///  5. Same bytes for the same seed, unless time or `progress` ended it.
/// Throws InputError when `from` or the goal is outside or inside an obstacle, and as prm().
PrmResult prm_path(const FreeSpace& space, Point from, const Goal& to, const PrmPlan& plan = {});

/// The query of graph_search() for a finished PRM (one that was kept, say): ends joined as in guarantees 2 and 3 of
/// prm_path().
GraphQuery prm_query(const FreeSpace& space, const Roadmap& roadmap, Point from, const Goal& to, double clearance = 0);

}  // namespace taut
