// The Euclidean shortest path in a free space.
#pragma once

#include <memory>
#include <optional>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/graph_search.h>
#include <taut/search/path.h>

namespace taut {

/// The shortest path from `from` to the goal; nothing when there is none. One-off: Polyanya on what lies between the
/// ends (Polyanya::between). Throws InputError when `from` or the goal lies outside the world or inside an obstacle
/// (with the point and, when it is known, the wall).
std::optional<Path> shortest_path(const FreeSpace& space, Point from, const Goal& to);
std::optional<Path> shortest_path(const FreeSpace& space, Point from, Point to);

/// The same length on a finished visibility graph, with counts and limits; another path where the method is not one
/// that finds the shortest (`optimal`).
GraphSearchResult shortest_path(const VisibilityGraph& graph, Point from, const Goal& to, GraphMethod method = {},
                                const SearchLimits& limits = {});

/// The query that shortest_path asks of graph.roadmap(), for other searches.
/// From within the goal room it is one leg of length 0.
GraphQuery visibility_query(const VisibilityGraph& graph, Point from, const Goal& to);

/// All shortest paths from one point, for many goals: Dijkstra once, then each goal costs one visibility expansion.
class ShortestPathTree {
 public:
  ShortestPathTree(std::shared_ptr<const VisibilityGraph> graph, Point from);

  /// Throws InputError when `to` is outside.
  std::optional<Path> path_to(Point to) const;
  Point from() const { return from_; }

 private:
  std::shared_ptr<const VisibilityGraph> graph_;
  Point from_;
  GraphShortestPaths paths_;
};

}  // namespace taut
