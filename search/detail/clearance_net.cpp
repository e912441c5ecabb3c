#include <taut/search/detail/clearance_net.h>

#include <algorithm>
#include <cmath>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/two_bit_color_map.hpp>
#include <boost/property_map/property_map.hpp>

namespace taut::detail {

namespace {

using Node = ClearanceNet::Node;

struct GoalTaken {};

/// A node's place in the queue: the length of the way to it, or the rank of the narrowest gate on it. Which of two
/// equal ones comes first is settled, so that the way found does not depend on the heap.
template <class Value>
struct QueueRank {
  Value value;
  Node node;
};

/// node -> place, over values that lie elsewhere.
template <class Value>
struct PlaceMap {
  using key_type = Node;
  using value_type = QueueRank<Value>;
  using reference = QueueRank<Value>;
  using category = boost::read_write_property_map_tag;

  Value* values;

  friend QueueRank<Value> get(PlaceMap map, Node v) { return {map.values[v], v}; }
  friend void put(PlaceMap map, Node v, Value value) { map.values[v] = value; }
};

struct PlusLength {
  double operator()(QueueRank<double> from, double leg) const { return from.value + leg; }
};

struct Shorter {
  bool operator()(double candidate, QueueRank<double> old) const { return candidate < old.value; }
  bool operator()(QueueRank<double> a, QueueRank<double> b) const {
    return a.value < b.value || (a.value == b.value && a.node < b.node);
  }
};

struct Narrower {
  std::uint32_t operator()(QueueRank<std::uint32_t> from, std::uint32_t gate) const {
    return std::min(from.value, gate);
  }
};

/// Ends of the query have the highest numbers: the goal comes before all that is as wide.
struct Wider {
  bool operator()(std::uint32_t candidate, QueueRank<std::uint32_t> old) const { return candidate > old.value; }
  bool operator()(QueueRank<std::uint32_t> a, QueueRank<std::uint32_t> b) const {
    return a.value > b.value || (a.value == b.value && a.node > b.node);
  }
};

struct ArcLengths {
  using key_type = ArcFrom;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  const Arc* arcs;

  friend double get(ArcLengths map, const ArcFrom& e) { return map.arcs[e.arc].length; }
};

struct ArcRanks {
  using key_type = ArcFrom;
  using value_type = std::uint32_t;
  using reference = std::uint32_t;
  using category = boost::readable_property_map_tag;

  const Arc* arcs;

  friend std::uint32_t get(ArcRanks map, const ArcFrom& e) { return map.arcs[e.arc].rank; }
};

class TreeVisitor : public boost::dijkstra_visitor<> {
 public:
  TreeVisitor(ArcTree& tree, Node goal) : tree_(&tree), goal_(goal) {}

  void examine_vertex(Node v, const WideArcs&) {
    if (v == goal_) throw GoalTaken{};
    ++tree_->expanded;
  }
  void edge_relaxed(const ArcFrom& e, const WideArcs&) { tree_->arc[e.to] = e.arc; }

 private:
  ArcTree* tree_;
  Node goal_;
};

class GoalVisitor : public boost::dijkstra_visitor<> {
 public:
  explicit GoalVisitor(Node goal) : goal_(goal) {}
  void examine_vertex(Node v, const WideArcs&) {
    if (v == goal_) throw GoalTaken{};
  }

 private:
  Node goal_;
};

using Identity = boost::typed_identity_property_map<Node>;

/// True when the visitor took the goal. Boost.Graph can be left early by an exception only.
template <class Value, class Weights, class Compare, class Combine, class Visitor>
bool dijkstra(const WideArcs& arcs, Node start, std::vector<Value>& values, Weights weights, Compare compare,
              Combine combine, Visitor visitor) {
  try {
    boost::dijkstra_shortest_paths_no_init(
        arcs, start, boost::dummy_property_map(), PlaceMap<Value>{values.data()}, weights, Identity(), compare, combine,
        QueueRank<Value>{values[start], start}, visitor, boost::two_bit_color_map<Identity>(num_vertices(arcs)));
  } catch (GoalTaken) {
    return true;
  }
  return false;
}

}  // namespace

void ClearanceNet::index() {
  offsets.assign(nodes + 1, 0);
  for (const Arc& a : arcs)
    for (const Node v : {a.from, a.to}) ++offsets[v + 1];
  for (Node v = 0; v < nodes; ++v) offsets[v + 1] += offsets[v];
  arcs_at.resize(2 * arcs.size());
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  for (std::uint32_t a = 0; a < arcs.size(); ++a)
    for (const Node v : {arcs[a].from, arcs[a].to}) arcs_at[next[v]++] = a;
}

ArcTree shortest_ways(const WideArcs& arcs, Node start, Node goal) {
  const std::size_t n = num_vertices(arcs);
  ArcTree tree{std::vector<std::uint32_t>(n, kNone), std::vector<double>(n, HUGE_VAL)};
  tree.length[start] = 0;
  tree.reached = dijkstra(arcs, start, tree.length, ArcLengths{arcs.net().arcs.data()}, Shorter{}, PlusLength{},
                          TreeVisitor(tree, goal));
  return tree;
}

std::optional<std::uint32_t> widest_bottleneck(const ClearanceNet& net, Node start, Node goal) {
  std::vector<std::uint32_t> least(net.nodes, 0);
  least[start] = kNone;
  if (!dijkstra(WideArcs(net, 0), start, least, ArcRanks{net.arcs.data()}, Wider{}, Narrower{}, GoalVisitor(goal)))
    return std::nullopt;
  return least[goal];
}

}  // namespace taut::detail
