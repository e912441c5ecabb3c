// All shortest paths from a start to the bends of a visibility graph, their lengths as numbers mean what was written.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/exact/signed_roots.h>
#include <taut/geometry/interval.h>
#include <taut/roadmaps/visibility_graph.h>

namespace taut::pursuit::detail {

/// |p - q|^2, exactly.
Rational squared_distance(const ExactPoint& p, const ExactPoint& q);

/// Dijkstra; lengths are enclosed, and where enclosures overlap compared as exact sums of roots (Length takes doubles
/// as they are, a target's clock cannot).
class BendTree {
 public:
  using Vertex = Roadmap::Vertex;

  BendTree(const VisibilityGraph& graph, Point start);

  /// Those that are reached, the nearest first (by the lower ends of their lengths).
  const std::vector<Vertex>& reached() const { return order_; }
  const Interval& length(Vertex v) const { return length_[v]; }
  std::vector<SignedRoot> roots(Vertex v) const;  ///< the sum of which is the length
  std::vector<Point> path(Vertex v) const;        ///< from the start to v

 private:
  void spread();
  void offer(Vertex to, Vertex before, const Interval& length);
  bool is_shorter(Vertex to, Vertex before, const Interval& length) const;

  const Roadmap& graph_;
  Point start_;
  std::vector<Interval> length_;
  std::vector<Vertex> before_;
  std::vector<bool> is_reached_;
  std::vector<std::pair<double, Vertex>> queue_;
  std::vector<Vertex> order_;
};

}  // namespace taut::pursuit::detail
