// Shortest paths in a Roadmap by Boost.Graph, with exact lengths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <taut/roadmaps/roadmap.h>
#include <taut/search/path.h>

namespace taut {

/// Both are exact; A* looks at fewer vertices.
enum class GraphAlgorithm { astar, dijkstra };

/// How a search ended.
enum class SearchStatus {
  found,    ///< the answer is optimal in the graph, proven
  none,     ///< the whole reachable part was searched: there is no path
  stopped,  ///< a limit was reached first
};

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

/// The answer, and what it took.
struct GraphSearchResult {
  SearchStatus status = SearchStatus::none;
  Path path;                  ///< when found; when stopped the best so far, if any. Consecutive equal points are merged
  std::size_t goal = 0;       ///< which goal it ends in, when found
  std::size_t expanded = 0;   ///< vertices taken from the queue and looked around from, the start included, goals not
  std::size_t generated = 0;  ///< vertices that ever got a length, start and goals included
};

/// The shortest way through the graph, exactly: labels are intervals; two that overlap are compared as the exact sums
/// of square roots they stand for (compare_lengths); equal ones keep the predecessor found first. The search goes on
/// until no open vertex could still improve the goal, so rounding decides nothing.
///  - astar: boost::astar_search_no_init, heuristic: distance to the nearest goal point, rounded down. Early exit.
///  - dijkstra: boost::dijkstra_shortest_paths_no_init (early exit as well).
/// Among goals equally far, the first of those reached. Precondition: V + goals < 2^32 - 1.
/// O((V + E) log V) in the part reached, the heuristic O(goals); memory 16 bytes a vertex, touched only in the part
/// reached, and 32 bytes each time a vertex gets a shorter way.
GraphSearchResult graph_search(const Roadmap& roadmap, const GraphQuery& query,
                               GraphAlgorithm algorithm = GraphAlgorithm::astar, const SearchLimits& limits = {});

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
