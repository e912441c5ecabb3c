// Boost's searches that look at no lengths: the first way found to a vertex stays. For .cpp files only.
#pragma once

#include <boost/graph/astar_search.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/depth_first_search.hpp>
#include <boost/pending/queue.hpp>

#include <taut/search/detail/search_state.h>

namespace taut::detail {

/// Gives a vertex its label when the search comes to it, and calls `expand(v)` before it looks around from v.
template <class Expand>
class BreadthFirstVisitor : public boost::bfs_visitor<> {
 public:
  BreadthFirstVisitor(SearchState& state, Expand expand) : state_(&state), expand_(expand) {}
  void examine_vertex(Roadmap::Vertex v, const QueryGraph&) { expand_(v); }
  void tree_edge(const Leg& leg, const QueryGraph&) { state_->relabel(leg.to, state_->label(leg.from)); }

 private:
  SearchState* state_;
  Expand expand_;
};

template <class Expand>
class DepthFirstVisitor : public boost::dfs_visitor<> {
 public:
  DepthFirstVisitor(SearchState& state, Expand expand) : state_(&state), expand_(expand) {}
  void discover_vertex(Roadmap::Vertex v, const QueryGraph&) { expand_(v); }
  void tree_edge(const Leg& leg, const QueryGraph&) { state_->relabel(leg.to, state_->label(leg.from)); }

 private:
  SearchState* state_;
  Expand expand_;
};

template <class Expand>
void breadth_first(SearchState& state, Expand expand) {
  boost::queue<Roadmap::Vertex> open;
  boost::breadth_first_visit(state.graph, state.graph.start(), open, BreadthFirstVisitor<Expand>(state, expand),
                             state.colors);
}

template <class Expand>
void depth_first(SearchState& state, Expand expand) {
  boost::depth_first_visit(state.graph, state.graph.start(), DepthFirstVisitor<Expand>(state, expand), state.colors);
}

/// The queue's order is that of estimates alone.
struct EstimateAlone : Combine {
  using Combine::operator();
  Entry operator()(LabelMap::Label at, double rest) const { return {rest, at.id, at.vertex}; }
};

/// "less": no way is shorter than the one found first.
struct FirstStays : Compare {
  using Compare::operator();
  bool operator()(Candidate c, LabelMap::Label old) const {
    return c.parent != Labels::kNone && old.id == Labels::kNone;
  }
};

}  // namespace taut::detail
