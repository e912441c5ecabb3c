// The Voronoi diagram with the ends of a query joined to it: arcs between numbered nodes, as a Boost.Graph. Includes
// Boost: for .cpp files only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>

#include <taut/roadmaps/voronoi.h>

namespace taut::detail {

/// A way between two nodes; `rank` is its gate's, kNone when it has none.
struct Arc {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t edge;  ///< kNone: a leg
  std::uint32_t rank;
  double length;
  Bezier curve;
};

/// An undirected multigraph: two nodes may have several arcs between them.
struct ClearanceNet {
  using Node = std::uint32_t;

  std::uint32_t nodes = 0;
  std::vector<Arc> arcs;
  std::vector<std::uint32_t> offsets, arcs_at;  ///< of node v: arcs_at[offsets[v] .. offsets[v + 1])

  /// To be called when all arcs are there. O(V + E).
  void index();
};

/// An arc, seen from one of its nodes.
struct ArcFrom {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t arc = 0;

  friend bool operator==(const ArcFrom&, const ArcFrom&) = default;
};

/// What of a net a disc can use: the arcs whose gate has at least this rank, as a VertexListGraph and IncidenceGraph.
/// The net must outlive it.
class WideArcs {
 public:
  using Node = ClearanceNet::Node;
  using vertex_descriptor = Node;
  using edge_descriptor = ArcFrom;
  using vertex_iterator = boost::counting_iterator<Node>;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  struct traversal_category : boost::vertex_list_graph_tag, boost::incidence_graph_tag {};

  class out_edge_iterator
      : public boost::iterator_facade<out_edge_iterator, ArcFrom, boost::forward_traversal_tag, ArcFrom> {
   public:
    out_edge_iterator() = default;
    out_edge_iterator(const WideArcs& arcs, Node from, std::uint32_t at)
        : net_(arcs.net_), rank_(arcs.rank_), from_(from), at_(at) {
      skip();
    }

   private:
    friend class boost::iterator_core_access;
    ArcFrom dereference() const {
      const std::uint32_t arc = net_->arcs_at[at_];
      const Arc& a = net_->arcs[arc];
      return {from_, a.from == from_ ? a.to : a.from, arc};
    }
    bool equal(const out_edge_iterator& other) const { return at_ == other.at_; }
    void increment() {
      ++at_;
      skip();
    }
    void skip() {
      const std::uint32_t end = net_->offsets[from_ + 1];
      while (at_ < end && net_->arcs[net_->arcs_at[at_]].rank < rank_) ++at_;
    }

    const ClearanceNet* net_ = nullptr;
    std::uint32_t rank_ = 0;
    Node from_ = 0;
    std::uint32_t at_ = 0;
  };

  WideArcs(const ClearanceNet& net, std::uint32_t rank) : net_(&net), rank_(rank) {}

  const ClearanceNet& net() const { return *net_; }

  friend std::size_t num_vertices(const WideArcs& g) { return g.net_->nodes; }
  friend std::pair<vertex_iterator, vertex_iterator> vertices(const WideArcs& g) {
    return {vertex_iterator(0), vertex_iterator(g.net_->nodes)};
  }
  friend std::pair<out_edge_iterator, out_edge_iterator> out_edges(Node v, const WideArcs& g) {
    return {{g, v, g.net_->offsets[v]}, {g, v, g.net_->offsets[v + 1]}};
  }
  friend std::size_t out_degree(Node v, const WideArcs& g) {
    const auto [first, last] = out_edges(v, g);
    return static_cast<std::size_t>(std::distance(first, last));
  }
  friend Node source(const ArcFrom& e, const WideArcs&) { return e.from; }
  friend Node target(const ArcFrom& e, const WideArcs&) { return e.to; }

 private:
  const ClearanceNet* net_;
  std::uint32_t rank_;
};

/// The shortest ways from a node, as far as the goal.
struct ArcTree {
  std::vector<std::uint32_t> arc;  ///< the last one of the way to a node, kNone where there is none
  std::vector<double> length;      ///< infinite where the search did not come
  bool reached = false;            ///< the goal
  std::size_t expanded = 0;        ///< nodes taken from the queue for good, the goal not
};

/// boost::dijkstra_shortest_paths_no_init: lengths are sums of doubles, ties go to the lower node, then to the arc
/// found first. Ends when the goal has the least length.
ArcTree shortest_ways(const WideArcs& arcs, ClearanceNet::Node start, ClearanceNet::Node goal);

/// The same search with the lesser of two ranks for their sum and the greater one first: the narrowest gate on the
/// widest way, kNone when it passes none. Nothing when they are not connected.
std::optional<std::uint32_t> widest_bottleneck(const ClearanceNet& net, ClearanceNet::Node start,
                                               ClearanceNet::Node goal);

}  // namespace taut::detail
