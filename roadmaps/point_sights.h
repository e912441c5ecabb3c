// What points see of a visibility graph, for many points.
#pragma once

#include <memory>
#include <span>

#include <taut/roadmaps/visibility_graph.h>

namespace taut {

/// VisibilityGraph::visible_from, prepared: twice as fast or more where the graph is reduced and vertices and points
/// lie on one lattice (IntegerPlaces); elsewhere it is asked. Immutable; 72 bytes a triangle, made in O(n).
class PointSights {
 public:
  /// The graph outlives it.
  explicit PointSights(const VisibilityGraph& graph);

  /// One point after the other in the same memory.
  class Finder {
   public:
    /// What it is made of outlives it.
    explicit Finder(const PointSights& sights);
    Finder(Finder&&) noexcept;
    ~Finder();

    /// The vertices that VisibilityGraph::visible_from says, in any order. Valid until the next call. Precondition: p
    /// is not outside.
    std::span<const Roadmap::Vertex> visible_from(Point p);

   private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
  };

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace taut
