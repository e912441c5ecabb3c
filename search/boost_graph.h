// A Roadmap as a Boost.Graph, for users who run their own algorithms on it. Optional: this header includes Boost.
//
//  1. taut::Roadmap models VertexListGraph, EdgeListGraph, IncidenceGraph and AdjacencyGraph (bidirectional in fact:
//     every edge is listed from both ends, so the graph is directed for Boost, with two edges a leg). Nothing is
//     copied.
//  2. A vertex is its index; get(boost::vertex_index, roadmap) is the identity.
//  3. get(boost::edge_weight, roadmap) is the leg's length as a double, to within an ulp, computed when it is read.
#pragma once

#include <cstddef>
#include <utility>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <taut/geometry/length.h>
#include <taut/roadmaps/roadmap.h>

namespace taut {

/// A leg of the roadmap with a direction: Boost.Graph's edge descriptor.
struct RoadmapEdge {
  Roadmap::Vertex from = 0;
  Roadmap::Vertex to = 0;

  friend bool operator==(const RoadmapEdge&, const RoadmapEdge&) = default;
};

struct RoadmapEdgeFrom {
  Roadmap::Vertex from = 0;
  RoadmapEdge operator()(Roadmap::Vertex to) const { return {from, to}; }
};

/// All edges, row by row.
class RoadmapEdgeIterator
    : public boost::iterator_facade<RoadmapEdgeIterator, RoadmapEdge, boost::forward_traversal_tag, RoadmapEdge> {
 public:
  RoadmapEdgeIterator() = default;
  RoadmapEdgeIterator(const Roadmap& roadmap, std::size_t row) : roadmap_(&roadmap), row_(row) { skip_empty_rows(); }

 private:
  friend class boost::iterator_core_access;

  auto neighbours() const { return roadmap_->neighbours(static_cast<Roadmap::Vertex>(row_)); }
  RoadmapEdge dereference() const { return {static_cast<Roadmap::Vertex>(row_), neighbours()[place_]}; }
  bool equal(const RoadmapEdgeIterator& other) const { return row_ == other.row_ && place_ == other.place_; }
  void increment() {
    if (++place_ < neighbours().size()) return;
    place_ = 0;
    ++row_;
    skip_empty_rows();
  }
  void skip_empty_rows() {
    while (row_ < roadmap_->vertex_count() && neighbours().empty()) ++row_;
  }

  const Roadmap* roadmap_ = nullptr;
  std::size_t row_ = 0;
  std::size_t place_ = 0;
};

/// edge -> length. The roadmap must outlive it.
struct RoadmapEdgeWeights {
  using key_type = RoadmapEdge;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  const Roadmap* roadmap = nullptr;

  friend double get(RoadmapEdgeWeights weights, const RoadmapEdge& e) {
    return distance_interval(weights.roadmap->point(e.from), weights.roadmap->point(e.to)).lo;
  }
};

}  // namespace taut

namespace boost {

template <>
struct graph_traits<taut::Roadmap> {
  struct traversal_category : vertex_list_graph_tag, edge_list_graph_tag, incidence_graph_tag, adjacency_graph_tag {};
  using directed_category = directed_tag;
  using edge_parallel_category = disallow_parallel_edge_tag;
  using vertex_descriptor = taut::Roadmap::Vertex;
  using edge_descriptor = taut::RoadmapEdge;
  using vertex_iterator = counting_iterator<vertex_descriptor>;
  using adjacency_iterator = const vertex_descriptor*;
  using out_edge_iterator =
      transform_iterator<taut::RoadmapEdgeFrom, const vertex_descriptor*, edge_descriptor, edge_descriptor>;
  using edge_iterator = taut::RoadmapEdgeIterator;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;

  static vertex_descriptor null_vertex() { return 0xffffffff; }
};

template <>
struct property_map<taut::Roadmap, vertex_index_t> {
  using type = typed_identity_property_map<taut::Roadmap::Vertex>;
  using const_type = type;
};

template <>
struct property_map<taut::Roadmap, edge_weight_t> {
  using type = taut::RoadmapEdgeWeights;
  using const_type = type;
};

}  // namespace boost

namespace taut {

// Found by argument-dependent lookup, as Boost.Graph wants its graphs' functions.

inline auto vertices(const Roadmap& g) {
  using Iterator = boost::graph_traits<Roadmap>::vertex_iterator;
  return std::pair(Iterator(0), Iterator(static_cast<Roadmap::Vertex>(g.vertex_count())));
}
inline std::size_t num_vertices(const Roadmap& g) { return g.vertex_count(); }

inline auto adjacent_vertices(Roadmap::Vertex v, const Roadmap& g) {
  const auto row = g.neighbours(v);
  return std::pair(row.data(), row.data() + row.size());
}
inline auto out_edges(Roadmap::Vertex v, const Roadmap& g) {
  using Iterator = boost::graph_traits<Roadmap>::out_edge_iterator;
  const auto row = g.neighbours(v);
  return std::pair(Iterator(row.data(), {v}), Iterator(row.data() + row.size(), {v}));
}
inline std::size_t out_degree(Roadmap::Vertex v, const Roadmap& g) { return g.neighbours(v).size(); }
inline auto edges(const Roadmap& g) {
  return std::pair(RoadmapEdgeIterator(g, 0), RoadmapEdgeIterator(g, g.vertex_count()));
}
inline std::size_t num_edges(const Roadmap& g) { return 2 * g.edge_count(); }

inline Roadmap::Vertex source(const RoadmapEdge& e, const Roadmap&) { return e.from; }
inline Roadmap::Vertex target(const RoadmapEdge& e, const Roadmap&) { return e.to; }

inline boost::typed_identity_property_map<Roadmap::Vertex> get(boost::vertex_index_t, const Roadmap&) { return {}; }
inline Roadmap::Vertex get(boost::vertex_index_t, const Roadmap&, Roadmap::Vertex v) { return v; }
inline RoadmapEdgeWeights get(boost::edge_weight_t, const Roadmap& g) { return {&g}; }
inline double get(boost::edge_weight_t, const Roadmap& g, const RoadmapEdge& e) {
  return get(RoadmapEdgeWeights{&g}, e);
}

}  // namespace taut
