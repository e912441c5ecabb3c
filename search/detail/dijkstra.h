// Boost's Dijkstra over exact labels. For .cpp files only.
#pragma once

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <taut/search/detail/search_state.h>

namespace taut::detail {

/// Calls `expand(v)` for each vertex taken from the queue and opens again what was expanded too early: legs shorter
/// than the rounding of a length (those between vertices at one point, for example) make lower bounds order the queue
/// only nearly right.
template <class Expand>
class DijkstraVisitor : public boost::dijkstra_visitor<> {
 public:
  DijkstraVisitor(SearchState& state, Expand expand) : state_(&state), expand_(expand) {}

  void examine_vertex(Roadmap::Vertex v, const QueryGraph&) { expand_(v); }

  void examine_edge(const Leg& leg, const QueryGraph&) {
    if (get(state_->colors, leg.to) != boost::two_bit_black) return;
    if (state_->labels.is_shorter(state_->label(leg.from), leg.to, state_->label(leg.to)))
      put(state_->colors, leg.to, boost::two_bit_white);
  }

 private:
  SearchState* state_;
  Expand expand_;
};

template <class Expand>
void dijkstra(SearchState& state, Expand expand) {
  boost::dijkstra_shortest_paths_no_init(state.graph, state.graph.start(), boost::dummy_property_map(),
                                         EntryMap{&state}, boost::typed_identity_property_map<Leg>(), SlotMap{&state},
                                         Compare{&state}, Combine{&state}, Entry{},
                                         DijkstraVisitor<Expand>(state, expand), state.colors);
}

}  // namespace taut::detail
