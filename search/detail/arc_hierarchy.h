// Shortest ways in a directed graph that can be turned round, prepared for many queries. Private.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <taut/geometry/triangulation.h>

namespace taut::detail {

/// A directed graph in which for each edge from n to m there is one as long from turned[m] to turned[n].
struct TurnableGraph {
  struct Edge {
    std::uint32_t to;
    double length;
  };
  std::vector<std::uint32_t> first;  ///< of each node, into edges
  std::vector<Edge> edges;
  std::vector<std::uint32_t> turned;  ///< of each node; may be the node itself

  std::size_t size() const { return turned.size(); }
};

/// A node, and how long the way to it is from the start, or from it to the goal.
struct ArcDoor {
  std::uint32_t node;
  double length;
};

/// A contraction hierarchy (Geisberger, Sanders, Schultes, Delling, 2008): nodes are taken out one after the other,
/// each together with its turned one, and edges put between their neighbours where no way without them is as short. A
/// shortest way leads up, to nodes taken out later, and then down; down is up, turned. Where that would make more and
/// more edges nodes are left, the core: a way may lead along its edges before it leads down.
///
/// Of the ways that pass no node twice, one way or the other: those from a node to its turned one are left out.
class ArcHierarchy {
 public:
  struct Edge {
    std::uint32_t to;
    std::uint32_t middle;  ///< a node that it passes; kNone of an edge of the graph
    double length;
  };

  explicit ArcHierarchy(const TurnableGraph& graph);

  std::span<const Edge> up(std::uint32_t n) const {
    return std::span(edges_).subspan(first_[n], first_[n + 1] - first_[n]);
  }
  bool is_core(std::uint32_t n) const { return is_core_[n] != 0; }
  std::uint32_t turned(std::uint32_t n) const { return turned_[n]; }
  std::size_t size() const { return turned_.size(); }
  std::size_t edge_count() const { return edges_.size(); }

  /// Appends the nodes after `from` on an edge up.
  void follow(std::uint32_t from, const Edge& edge, std::vector<std::uint32_t>& nodes) const;

 private:
  void follow(std::uint32_t from, std::uint32_t to, std::uint32_t middle, std::vector<std::uint32_t>& nodes) const;
  const Edge& edge_to(std::uint32_t from, std::uint32_t to) const;

  std::vector<std::uint32_t> first_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> turned_;
  std::vector<std::uint8_t> is_core_;
};

}  // namespace taut::detail
