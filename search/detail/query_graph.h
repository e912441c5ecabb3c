// A Roadmap with the two ends of a query joined to it, as a Boost.Graph. Includes Boost: for .cpp files only.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_facade.hpp>

#include <taut/search/graph_search.h>

namespace taut::detail {

/// A leg of the query graph.
struct Leg {
  Roadmap::Vertex from = 0;
  Roadmap::Vertex to = 0;

  friend bool operator==(const Leg&, const Leg&) = default;
};

/// An IncidenceGraph over an unchanged roadmap of n vertices: n is the start, n + 1 + i is goal i. Legs lead out of the
/// start and into the goals only. The legs of a vertex are two ranges of targets: the roadmap's row, then the goals it
/// sees.
class QueryGraph {
 public:
  using Vertex = Roadmap::Vertex;
  using vertex_descriptor = Vertex;
  using edge_descriptor = Leg;
  using degree_size_type = std::size_t;
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  using traversal_category = boost::incidence_graph_tag;

  struct Row {
    std::span<const Vertex> first, second;
  };

  class out_edge_iterator : public boost::iterator_facade<out_edge_iterator, Leg, boost::forward_traversal_tag, Leg> {
   public:
    out_edge_iterator() = default;
    out_edge_iterator(Vertex from, const Row& row, std::size_t at) : row_(row), at_(at), from_(from) {}

   private:
    friend class boost::iterator_core_access;
    Leg dereference() const {
      return {from_, at_ < row_.first.size() ? row_.first[at_] : row_.second[at_ - row_.first.size()]};
    }
    bool equal(const out_edge_iterator& other) const { return at_ == other.at_; }
    void increment() { ++at_; }

    Row row_;
    std::size_t at_ = 0;
    Vertex from_ = 0;
  };

  /// The query must outlive the graph.
  QueryGraph(const Roadmap& roadmap, const GraphQuery& query) : roadmap_(roadmap), query_(query) {
    std::vector<std::pair<Vertex, Vertex>> legs;
    for (std::size_t i = 0; i < query.goals.size(); ++i)
      for (const Vertex v : query.goals[i].vertices) legs.emplace_back(v, goal(i));
    std::sort(legs.begin(), legs.end());
    if (!legs.empty()) sees_goal_.resize(roadmap.vertex_count());
    for (const auto& [from, to] : legs) {
      sees_goal_[from] = true;
      leg_from_.push_back(from);
      leg_to_.push_back(to);
    }
    for (const std::size_t i : query.direct) direct_.push_back(goal(i));
  }

  const Roadmap& roadmap() const { return roadmap_; }
  const GraphQuery& query() const { return query_; }
  std::size_t vertex_count() const { return roadmap_.vertex_count() + 1 + query_.goals.size(); }
  Vertex start() const { return static_cast<Vertex>(roadmap_.vertex_count()); }
  Vertex goal(std::size_t i) const { return static_cast<Vertex>(start() + 1 + i); }
  bool is_goal(Vertex v) const { return v > start(); }

  /// Goals first, then by index: the order of vertices of equal length.
  Vertex rank(Vertex v) const { return is_goal(v) ? v - start() - 1 : static_cast<Vertex>(v + query_.goals.size()); }

  Row row(Vertex v) const {
    if (v < start()) return {roadmap_.neighbours(v), goals_seen_from(v)};
    if (v == start()) return {query_.start.vertices, direct_};
    return {};
  }

 private:
  std::span<const Vertex> goals_seen_from(Vertex v) const {
    if (sees_goal_.empty() || !sees_goal_[v]) return {};
    const auto [first, last] = std::equal_range(leg_from_.begin(), leg_from_.end(), v);
    return {leg_to_.data() + (first - leg_from_.begin()), static_cast<std::size_t>(last - first)};
  }

  const Roadmap& roadmap_;
  const GraphQuery& query_;
  std::vector<bool> sees_goal_;
  std::vector<Vertex> leg_from_, leg_to_, direct_;
};

inline std::size_t out_degree(QueryGraph::Vertex v, const QueryGraph& g) {
  const QueryGraph::Row row = g.row(v);
  return row.first.size() + row.second.size();
}
inline std::pair<QueryGraph::out_edge_iterator, QueryGraph::out_edge_iterator> out_edges(QueryGraph::Vertex v,
                                                                                         const QueryGraph& g) {
  const QueryGraph::Row row = g.row(v);
  return {{v, row, 0}, {v, row, row.first.size() + row.second.size()}};
}
inline QueryGraph::Vertex source(const Leg& leg, const QueryGraph&) { return leg.from; }
inline QueryGraph::Vertex target(const Leg& leg, const QueryGraph&) { return leg.to; }

}  // namespace taut::detail
