// Replanning: the shortest path in a graph whose edges change while the robot is under way.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include <taut/search/graph_search.h>
#include <taut/search/indexed_heap.h>
#include <taut/search/replanning_graph.h>

namespace taut {

/// D* Lite, the optimised version (Koenig and Likhachev, "D* Lite", AAAI 2002, figure 4): searches backwards from a
/// goal that stays and repairs only what a change touches, while the start moves. Without moves it is LPA* run
/// backwards. Different here: of states with the same estimate the paper takes that nearest to the goal, which on an
/// open grid is every cell between start and goal; here it is those that became dearer, then those nearest to the
/// start.
///
/// Use: change the graph, name every state whose outgoing edges changed (`changed`), move the start (`move_to`), then
/// replan(). Edges and states may appear and vanish; whichever way, the state an edge leaves from is named.
///
///  1. With integers cost() after replan() is the cost of a cheapest path, exactly, whatever was changed before; `none`
///     is proven.
///  2. path() is such a path. Among equal ones it takes the successor found first, so equal histories give equal paths.
///  3. With floating-point costs cost() is, to the bit, what Dijkstra's algorithm run backwards from the goal in the
///     same arithmetic gives (c + rest, rounded once an edge): within n * 2^-53 of the exact value for n edges, and a
///     path within twice that of the cheapest. Provided that no edge is cheaper than 2^-28 of the largest cost that
///     occurs, and up to 2^15 moves for every edge of the shortest path; heuristics are multiplied by 1 - 2^-10 for
///     that. Exact sums of square roots: RoadmapReplanner.
///  4. A stopped replan() goes on where it stood when called again.
/// The graph must outlive it. Memory: about 60 bytes a state met, and 40 more in a hash table or 4 for every state of a
/// NumberedGraph. `Costs` adds and compares costs; see NumberCosts.
template <ReplanningGraph Graph, class Costs = NumberCosts<typename Graph::Cost>,
          class Hash = std::hash<typename Graph::State>>
class DstarLite {
 public:
  using State = typename Graph::State;
  using Cost = typename Costs::Cost;
  using Key = typename Costs::Key;

  DstarLite(const Graph& graph, State start, State goal, Costs costs = {})
      : graph_(&graph), costs_(std::move(costs)), numbers_(graph) {
    begin(std::move(start), std::move(goal));
  }

  /// The cost of edges out of s changed, or edges appeared or vanished. O(1): replan() looks at each such state once,
  /// however often it was named.
  void changed(const State& s) {
    const Index u = node(s);
    if (u == goal_ || nodes_[u].is_changed) return;
    nodes_[u].is_changed = true;
    changed_.push_back(u);
  }

  void move_to(const State& start) { start_ = node(start); }

  /// Forgets everything and searches anew: for a goal that moves, or when most edges changed.
  void restart(State start, State goal) {
    nodes_.clear();
    numbers_.clear();
    heap_.clear();
    changed_.clear();
    moved_ = Key{};
    begin(std::move(start), std::move(goal));
  }

  /// Until the start's cost is final, or a limit ends it.
  SearchStatus replan(const SearchLimits& limits = {}) {
    const auto begin = std::chrono::steady_clock::now();
    const auto late = [&] {
      return limits.seconds < 1e9 && expanded_ % 64 == 0 &&
             std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() >= limits.seconds;
    };
    take_move();
    take_changes();
    expanded_ = 0;
    while (is_unsettled()) {
      if (expanded_ >= limits.expansions || late()) return SearchStatus::stopped;
      step();
    }
    return costs_.is_infinite(cost()) ? SearchStatus::none : SearchStatus::found;
  }

  /// Of the start, after replan() has found; infinite when there is no path.
  const Cost& cost() const { return nodes_[start_].ahead; }

  /// From the start to the goal; empty when there is none. Precondition: replan() was not stopped.
  std::vector<State> path() const {
    std::vector<State> states;
    if (costs_.is_infinite(cost())) return states;
    for (Index u = start_;; u = nodes_[u].next) {
      states.push_back(nodes_[u].state);
      if (u == goal_) return states;
    }
  }

  /// The state to go to from the start. Precondition: replan() found a path, and start is not the goal.
  const State& next() const { return nodes_[nodes_[start_].next].state; }

  const State& start() const { return nodes_[start_].state; }
  const State& goal() const { return nodes_[goal_].state; }
  std::size_t expanded() const { return expanded_; }  ///< states taken from the queue by the last replan()
  std::size_t states() const { return nodes_.size(); }
  Costs& costs() { return costs_; }
  const Costs& costs() const { return costs_; }

 private:
  using Index = std::uint32_t;
  static constexpr Index kNowhere = 0xffffffff;

  /// By the least cost of a path through the state. Of equal ones those that became dearer come first, so that nobody
  /// goes on building upon them; then what is nearer to the start.
  struct Priority {
    Key through{};
    bool is_cheaper = true;
    Key rest{};

    friend bool operator<(const Priority& a, const Priority& b) {
      if constexpr (std::is_same_v<Key, int>) return a.packed() < b.packed();
      if (a.through < b.through || b.through < a.through) return a.through < b.through;
      if (a.is_cheaper != b.is_cheaper) return b.is_cheaper;
      return a.rest < b.rest;
    }
    /// The same order for numbers that are not negative, without a branch.
    std::uint64_t packed() const {
      return static_cast<std::uint64_t>(through) << 32 | std::uint64_t{is_cheaper} << 31 |
             static_cast<std::uint64_t>(rest);
    }
  };

  struct Node {
    State state;
    Cost cost;   // g: what the neighbours know
    Cost ahead;  // rhs: one step of looking ahead
    Index next = kNowhere;
    Index place = kNowhere;  // in the heap
    bool is_changed = false;
  };

  void begin(State start, State goal) {
    start_ = last_ = node(start);
    goal_ = node(goal);
    nodes_[goal_].ahead = Cost{};
    queue(goal_);
  }

  Index node(const State& s) {
    const auto next = static_cast<Index>(nodes_.size());
    const Index u = numbers_.number(s, next);
    if (u == next) nodes_.push_back({s, costs_.infinity(), costs_.infinity()});
    return u;
  }

  /// The robot moved: what is queued became nearer by as much at most.
  void take_move() {
    if (last_ == start_) return;
    moved_ = costs_.key_plus(moved_, costs_.weakened(graph_->heuristic(nodes_[last_].state, nodes_[start_].state)));
    last_ = start_;
  }

  void take_changes() {
    for (const Index u : changed_) {
      nodes_[u].is_changed = false;
      look_ahead(u);
      queue(u);
    }
    changed_.clear();
  }

  Priority priority(Index u) const {
    const Node& n = nodes_[u];
    const bool is_cheaper = costs_.is_less(n.ahead, n.cost);
    const Cost& least = is_cheaper ? n.ahead : n.cost;
    if (costs_.is_infinite(least)) return {costs_.key_infinity(), is_cheaper, Key{}};
    const Key rest = u == last_ ? Key{} : costs_.weakened(graph_->heuristic(nodes_[last_].state, n.state));
    return {costs_.key_plus(costs_.key_plus(costs_.key(least), rest), moved_), is_cheaper, rest};
  }

  /// Is there anything left on which the start's cost may rest, or that may make it less?
  bool is_unsettled() const {
    if (heap_.empty()) return false;
    const Node& s = nodes_[start_];
    const Priority &top = heap_.top().priority, here = priority(start_);
    if (top.through < here.through || costs_.is_less(s.cost, s.ahead)) return true;
    return !top.is_cheaper && !(here.through < top.through);
  }

  void step() {
    const Index u = heap_.top().node;
    const Priority now = priority(u);
    if (heap_.top().priority.through < now.through) return heap_.set(nodes_, u, now);
    ++expanded_;
    now.is_cheaper ? settle(u) : raise(u);
  }

  void settle(Index u) {
    nodes_[u].cost = nodes_[u].ahead;
    queue(u);
    const State state = nodes_[u].state;
    graph_->each_in(state, [&](const State& from, const auto& edge) {
      const Index s = node(from);
      if (s == goal_ || s == u || !costs_.plus_is_less(edge, nodes_[u].cost, nodes_[s].ahead)) return;
      nodes_[s].ahead = costs_.plus(edge, nodes_[u].cost);
      nodes_[s].next = u;
      queue(s);
    });
  }

  void raise(Index u) {
    nodes_[u].cost = costs_.infinity();
    queue(u);
    const State state = nodes_[u].state;
    graph_->each_in(state, [&](const State& from, const auto&) {
      const Index s = node(from);
      if (s == goal_ || nodes_[s].next != u) return;
      look_ahead(s);
      queue(s);
    });
  }

  void look_ahead(Index u) {
    Cost least = costs_.infinity();
    Index next = kNowhere;
    const State state = nodes_[u].state;
    graph_->each_out(state, [&](const State& to, const auto& edge) {
      const Index s = node(to);
      if (s == u || !costs_.plus_is_less(edge, nodes_[s].cost, least)) return;
      least = costs_.plus(edge, nodes_[s].cost);
      next = s;
    });
    // An equal sum keeps its name, so that comparing it stays cheap.
    if (!costs_.is_equal(least, nodes_[u].ahead)) nodes_[u].ahead = least;
    nodes_[u].next = next;
  }

  /// Into the queue, out of it or to another place in it.
  void queue(Index u) {
    const Node& n = nodes_[u];
    const bool settled = costs_.is_equal(n.cost, n.ahead);
    if (settled && n.place == kNowhere) return;
    settled ? heap_.remove(nodes_, u) : heap_.set(nodes_, u, priority(u));
  }

  const Graph* graph_;
  Costs costs_;
  std::vector<Node> nodes_;
  detail::StateNumbers<Graph, Hash> numbers_;
  IndexedHeap<Priority> heap_;
  std::vector<Index> changed_;  // since the last replan()
  Index start_ = 0, goal_ = 0, last_ = 0;
  Key moved_{};
  std::size_t expanded_ = 0;
};

}  // namespace taut
