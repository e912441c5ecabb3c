// What Boost.Graph's searches read and write: property maps over labels, and how they are compared. For .cpp files
// only.
#pragma once

#include <cstdlib>
#include <memory>
#include <new>

#include <boost/graph/two_bit_color_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <taut/search/detail/labels.h>
#include <taut/search/detail/query_graph.h>

namespace taut::detail {

/// The state of one search. Per vertex 16 bytes of zeroed pages, touched only where the search comes, and 2 bits of
/// colour.
///
/// Why the answer is exact although the queue is ordered by rounded lower bounds: a vertex gets another label only when
/// that is strictly shorter, exactly, and is then open again, also when it had been expanded. So as long as a goal's
/// label is not the shortest possible, some vertex on a shortest path is open with its final label, and its key, a
/// lower bound of the whole path, is below the goal's length. A goal's key is the upper bound of its length and the
/// search ends when a goal has the least key: no open vertex can improve on it any more. Among the goals labelled by
/// then the shortest is chosen, exactly.
class SearchState {
 public:
  using Vertex = Roadmap::Vertex;
  using Id = Labels::Id;

  explicit SearchState(const QueryGraph& query_graph)
      : graph(query_graph),
        labels(graph.roadmap(), graph.query().start.point, goal_points(graph.query())),
        colors(graph.vertex_count()),
        vertices_(static_cast<PerVertex*>(std::calloc(graph.vertex_count(), sizeof(PerVertex)))) {
    if (!vertices_) throw std::bad_alloc();
    vertices_[graph.start()].label = Labels::kStart;
  }

  Id label(Vertex v) const { return vertices_[v].label; }
  double key(Vertex v) const { return vertices_[v].key; }
  std::uint32_t slot(Vertex v) const { return vertices_[v].slot; }
  std::size_t reached() const { return reached_; }

  void set_key(Vertex v, double key) { vertices_[v].key = key; }
  void relabel(Vertex v, Id parent) {
    PerVertex& state = vertices_[v];
    if (state.label == Labels::kNone) state.slot = reached_++;
    state.label = labels.extend(parent, v, state.label);
  }

  /// The order in the queue of a vertex from which at least `rest` is still to go.
  double bound(Vertex v, double rest) const {
    const Labels::Label& l = labels[label(v)];
    return graph.is_goal(v) ? l.hi : twofold::add_down(l.lo, rest);
  }

  const QueryGraph& graph;
  Labels labels;
  boost::two_bit_color_map<boost::typed_identity_property_map<Vertex>> colors;

 private:
  struct PerVertex {
    double key;
    Id label;
    std::uint32_t slot;  ///< the how manieth vertex reached
  };
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };

  static std::vector<Point> goal_points(const GraphQuery& query) {
    std::vector<Point> points;
    for (const Terminal& goal : query.goals) points.push_back(goal.point);
    return points;
  }

  std::unique_ptr<PerVertex[], Free> vertices_;
  std::uint32_t reached_ = 1;
};

/// A way to a vertex that may become its label.
struct Candidate {
  Labels::Id parent = Labels::kNone;
  Roadmap::Vertex vertex = 0;
};

/// A vertex's place in the queue.
struct Entry {
  double key = 0;
  Labels::Id label = Labels::kNone;
  Roadmap::Vertex vertex = 0;
};

/// vertex -> label. What A* calls distance.
struct LabelMap {
  struct Label {
    Labels::Id id = Labels::kNone;
    Roadmap::Vertex vertex = 0;
  };
  using key_type = Roadmap::Vertex;
  using value_type = Label;
  using reference = Label;
  using category = boost::read_write_property_map_tag;

  SearchState* state;

  friend Label get(LabelMap map, key_type v) { return {map.state->label(v), v}; }
  friend void put(LabelMap map, key_type v, Candidate c) { map.state->relabel(v, c.parent); }
};

/// vertex -> place in the queue. What A* calls cost, and Dijkstra distance.
struct EntryMap {
  using key_type = Roadmap::Vertex;
  using value_type = Entry;
  using reference = Entry;
  using category = boost::read_write_property_map_tag;

  SearchState* state;

  friend Entry get(EntryMap map, key_type v) { return {map.state->key(v), map.state->label(v), v}; }
  friend void put(EntryMap map, key_type v, Entry e) { map.state->set_key(v, e.key); }
  friend void put(EntryMap map, key_type v, Candidate c) {
    map.state->relabel(v, c.parent);
    map.state->set_key(v, map.state->bound(v, 0));
  }
};

/// vertex -> the how manieth reached, so that what Boost keeps per vertex grows with the part searched.
struct SlotMap {
  using key_type = Roadmap::Vertex;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  SearchState* state;

  friend std::size_t get(SlotMap map, key_type v) { return map.state->slot(v); }
};

/// "distance + weight", put off until a comparison needs it.
struct Combine {
  SearchState* state;

  Candidate operator()(LabelMap::Label from, Leg leg) const { return {from.id, leg.to}; }
  Candidate operator()(Entry from, Leg leg) const { return {from.label, leg.to}; }
  Entry operator()(LabelMap::Label at, double rest) const { return {state->bound(at.vertex, rest), at.id, at.vertex}; }
};

/// "less": exact between a candidate and the label it would replace, by key in the queue.
struct Compare {
  SearchState* state;

  bool operator()(Candidate c, LabelMap::Label old) const { return is_shorter(c, old.id); }
  bool operator()(Candidate c, Entry old) const { return is_shorter(c, old.label); }
  bool operator()(Entry a, Entry b) const {
    return a.key < b.key || (a.key == b.key && state->graph.rank(a.vertex) < state->graph.rank(b.vertex));
  }
  /// Of one vertex: it was relabelled because that is shorter.
  bool operator()(LabelMap::Label now, LabelMap::Label before) const { return now.id > before.id; }
  /// No leg is shorter than zero.
  bool operator()(Leg, Entry) const { return false; }

 private:
  bool is_shorter(Candidate c, Labels::Id old) const {
    if (c.parent == Labels::kNone) return false;  // Boost asks whether the leg alone is shorter than zero
    return old == Labels::kNone || state->labels.is_shorter(c.parent, c.vertex, old);
  }
};

}  // namespace taut::detail
