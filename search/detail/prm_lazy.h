// Shortest paths on a PRM whose edges have not been tested yet. Private.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <taut/roadmaps/prm_growth.h>
#include <taut/search/graph_search.h>

namespace taut::detail {

/// One search; the growth must not grow meanwhile.
class PrmLazySearch {
 public:
  PrmLazySearch(PrmGrowth& growth, const GraphQuery& query);

  /// The shortest path by free edges, nothing when there is none.
  std::optional<GraphSearchResult> search(GraphAlgorithm algorithm);

 private:
  struct Open {
    double key, length;  // key: with the distance to the nearest goal
    Roadmap::Vertex to;
    std::uint32_t edge;  // kNone: a leg of a terminal
  };

  bool reaches_goal();
  void push(Roadmap::Vertex to, double length, std::uint32_t edge);
  bool test_legs(const Path& path);
  std::span<const std::uint32_t> edges_at(Roadmap::Vertex v) const;

  PrmGrowth& growth_;
  const GraphQuery& query_;
  std::vector<std::uint32_t> offsets_, edges_;  // compressed rows of edge numbers
  std::vector<Open> open_;
};

}  // namespace taut::detail
