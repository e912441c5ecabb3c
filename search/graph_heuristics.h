// What is true of an estimate on a given Roadmap.
#pragma once

#include <optional>

#include <taut/geometry/point.h>
#include <taut/search/graph_search.h>

namespace taut {

/// What an estimate is worth for a query: heuristic_verdict().
struct GraphHeuristicVerdict {
  /// Proven: along no leg of the graph, ends joined, does the estimate fall by more than the leg is long. So it is
  /// nowhere above the true cost, and what A* finds is the shortest
  bool consistent = false;
  /// A witness that it is not admissible. When it is neither consistent nor has a witness, nothing is known
  std::optional<GraphOverestimate> overestimate;
};

/// Manhattan and octile are norms that no straight leg is longer than: consistent where on every leg they equal its
/// length, which is decided exactly (legs along the axes; for octile at 45 degrees, too). Else the witness is the
/// vertex, or the start, where the estimate is farthest above the length of a way to a goal (roadmap_distances), the
/// start first among equals, then the lower vertex; that it is above is exact. Euclidean, Chebyshev and zero are
/// consistent by their formulas. O((V + E + goals) log V).
GraphHeuristicVerdict heuristic_verdict(const Roadmap& roadmap, const GraphQuery& query, GraphHeuristic heuristic);

}  // namespace taut
