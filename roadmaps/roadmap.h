// A graph drawn in free space: what every builder makes and every search reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <taut/geometry/point.h>

namespace taut {

/// An immutable undirected graph whose vertices are points and whose edges are straight legs, in compressed rows: the
/// neighbours of vertex v are targets[offsets[v] .. offsets[v + 1]), ascending, each edge listed from both ends.
/// Several vertices may lie at one point (the sides of a wall are different places). At most 2^32 - 2 vertices; edges
/// are limited by memory only (8 bytes an undirected edge).
class Roadmap {
 public:
  using Vertex = std::uint32_t;

  Roadmap() : offsets_(1, 0) {}
  /// From edges in any order; loops and duplicates are dropped. Precondition: ends < points.size(). O(V + E log E).
  Roadmap(std::vector<Point> points, std::span<const std::pair<Vertex, Vertex>> edges);
  /// From finished rows. Precondition: they are symmetric, each row ascending without repeats.
  Roadmap(std::vector<Point> points, std::vector<std::uint64_t> offsets, std::vector<Vertex> targets);

  std::size_t vertex_count() const { return points_.size(); }
  std::size_t edge_count() const { return targets_.size() / 2; }
  const std::vector<Point>& points() const { return points_; }
  Point point(Vertex v) const { return points_[v]; }
  std::span<const Vertex> neighbours(Vertex v) const {
    return {targets_.data() + offsets_[v], targets_.data() + offsets_[v + 1]};
  }
  bool adjacent(Vertex u, Vertex v) const;  ///< O(log degree)

  friend bool operator==(const Roadmap&, const Roadmap&) = default;

 private:
  std::vector<Point> points_;
  std::vector<std::uint64_t> offsets_;
  std::vector<Vertex> targets_;
};

}  // namespace taut
