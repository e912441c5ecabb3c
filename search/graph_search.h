// Shortest paths in a Roadmap by Boost.Graph, with exact lengths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <taut/roadmaps/roadmap.h>
#include <taut/search/graph_method.h>
#include <taut/search/path.h>
#include <taut/search/search_status.h>

namespace taut {

/// Limits of one search; the default has none.
struct SearchLimits {
  std::size_t expansions = SIZE_MAX;
  double seconds = 1e300;
};

/// How an end of a query joins the graph: by a straight leg from `point` to each of `vertices`.
struct Terminal {
  Point point;
  std::vector<Roadmap::Vertex> vertices;
};

/// A query: from one terminal to the nearest of several. A leg from the start straight to goal i exists iff `direct`
/// holds i.
struct GraphQuery {
  Terminal start;
  std::vector<Terminal> goals;
  std::vector<std::size_t> direct;
};

/// An estimate above the true cost, at a vertex or at the start: so A* can miss the shortest path.
struct GraphOverestimate {
  Point at;
  double estimate = 0;  ///< to the nearest double
  double cost = 0;  ///< of a way from there to a goal, the shortest but for rounding; proven to be below the estimate

  friend bool operator==(const GraphOverestimate&, const GraphOverestimate&) = default;
};

/// The answer, and what it took.
struct GraphSearchResult {
  SearchStatus status = SearchStatus::none;
  Path path;                  ///< when found; when stopped the best so far, if any. Consecutive equal points are merged
  std::size_t goal = 0;       ///< which goal it ends in, when found
  std::size_t expanded = 0;   ///< vertices taken from the queue and looked around from, the start included, goals not
  std::size_t generated = 0;  ///< vertices that ever got a length, start and goals included
  bool optimal = true;        ///< when found: it is the shortest in the graph, proven
  /// Of A* with an estimate that is not admissible: where that shows
  std::optional<GraphOverestimate> overestimate{};
};

/// A way through the graph. Lengths are exact: labels are intervals; two that overlap are compared as the exact sums of
/// square roots they stand for (compare_lengths); equal ones keep the predecessor found first. Each search ends when it
/// takes a goal from its queue.
///  - astar: boost::astar_search_no_init. Estimates are to the nearest goal, rounded down. Where they are admissible
///  the
///    search goes on until no open vertex could still improve the goal, so rounding decides nothing and the path is the
///    shortest: `optimal`. Manhattan and octile are admissible on few graphs (heuristic_verdict): elsewhere the path is
///    not called optimal, also when it happens to be, and `overestimate` is the witness.
///  - dijkstra: boost::dijkstra_shortest_paths_no_init. The shortest.
///  - bfs: boost::breadth_first_visit, dfs: boost::depth_first_visit, greedy: boost::astar_search_no_init ordered by
///  the
///    estimate alone. Some path, never called optimal; bfs has the fewest legs, those of the ends included.
/// All search the whole reachable part before they say `none`. Among goals equally far, the first of those reached.
/// Precondition: V + goals < 2^32 - 1. O((V + E) log V) in the part reached, the heuristic O(goals); memory 16 bytes a
/// vertex, touched only in the part reached, and 32 bytes each time a vertex gets a shorter way.
GraphSearchResult graph_search(const Roadmap& roadmap, const GraphQuery& query, GraphMethod method = {},
                               const SearchLimits& limits = {});

/// All shortest paths from one terminal (boost::dijkstra_shortest_paths), kept for many goals.
class GraphShortestPaths {
 public:
  GraphShortestPaths(std::shared_ptr<const Roadmap> roadmap, Terminal start);

  /// The best path to `goal`, by its own legs or straight (`direct`); nothing when it is not reached. O(goal.vertices +
  /// answer).
  std::optional<Path> path_to(const Terminal& goal, bool direct) const;
  /// The predecessor of v on its shortest path; kNoVertex for those joined to the start itself or not reached.
  Roadmap::Vertex predecessor(Roadmap::Vertex v) const;
  bool reached(Roadmap::Vertex v) const;

  static constexpr Roadmap::Vertex kNoVertex = 0xffffffff;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace taut
