// Replanning on a roadmap whose legs can be blocked or become dearer, with exact lengths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include <taut/roadmaps/roadmap.h>
#include <taut/search/graph_search.h>
#include <taut/search/path.h>

namespace taut {

/// DstarLite on a Roadmap. Costs are lengths, kept as the sums of square roots they are; those that overlap as
/// intervals are compared exactly, so after any history the answer is exactly what a search from scratch finds.
///
///  1. A leg counts its length `factor` times (comparing ties takes time in proportion to the factors: keep them
///     small); a blocked one cannot be taken. Both act in both directions. All begin free, with factor 1.
///  2. path() is as short as any (factors counted); of equal ones which one depends on the history. cost() is its
///     length, factors counted: the length of the path itself when all its factors are 1.
///  3. Nothing is found when start and goal are not connected, proven.
/// Memory: 24 bytes each time a vertex gets another length, given back by a fresh search after 2^22 of them.
class RoadmapReplanner {
 public:
  using Vertex = Roadmap::Vertex;

  /// Precondition: start and goal are vertices; no leg has length 0.
  RoadmapReplanner(std::shared_ptr<const Roadmap> roadmap, Vertex start, Vertex goal);
  ~RoadmapReplanner();
  RoadmapReplanner(RoadmapReplanner&&) noexcept;
  RoadmapReplanner& operator=(RoadmapReplanner&&) noexcept;

  // Precondition: u and v are adjacent.
  void block(Vertex u, Vertex v);
  void unblock(Vertex u, Vertex v);
  void set_factor(Vertex u, Vertex v, std::uint32_t factor);  ///< Precondition: factor > 0

  void move_to(Vertex start);
  void set_goal(Vertex goal);  ///< searches from scratch next time

  SearchStatus replan(const SearchLimits& limits = {});

  // Precondition: replan() was not stopped and nothing changed since.
  std::optional<Path> path() const;
  std::optional<Length> cost() const;

  std::size_t expanded() const;  ///< by the last replan()

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
