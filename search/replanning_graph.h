// What DstarLite asks of a graph and of its costs.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace taut {

/// How plain numbers are added up as costs. Integers: exact, infinity is the largest value, sums saturate there.
/// Floating point: see guarantee 3 of DstarLite.
template <class Number>
struct NumberCosts {
  using Cost = Number;
  using Key = Number;

  static constexpr Number infinity() {
    if constexpr (std::floating_point<Number>) return std::numeric_limits<Number>::infinity();
    return std::numeric_limits<Number>::max();
  }
  static constexpr Key key_infinity() { return infinity(); }
  static bool is_infinite(Number cost) { return cost == infinity(); }
  static bool is_less(Number a, Number b) { return a < b; }
  static bool is_equal(Number a, Number b) { return a == b; }
  static Number plus(Number edge, Number rest) {
    if constexpr (std::floating_point<Number>) return edge + rest;
    return rest > infinity() - edge ? infinity() : static_cast<Number>(edge + rest);
  }
  static bool plus_is_less(Number edge, Number rest, Number than) { return plus(edge, rest) < than; }
  static Key key(Number cost) { return cost; }
  static Key key_plus(Key a, Key b) { return plus(a, b); }
  /// A heuristic as it enters the queue: rounding must never hide that it is too small.
  static Key weakened(Key heuristic) {
    if constexpr (std::floating_point<Number>) return heuristic * (1 - Number(1) / 1024);
    return heuristic;
  }
};

/// What DstarLite asks of a graph; it may be implicit (a grid, a lattice of poses): states are made up as they are met.
///  - State: copyable, ==, std::hash or the Hash parameter.
///  - each_out(s, visit): visit(t, edge) for every edge s -> t as it is now; each_in(s, visit): visit(t, edge) for
///    every edge t -> s. Both in an order that depends on the graph alone. An edge of infinite cost is no edge and may
///    be listed. Edges cost more than 0.
///  - heuristic(s, t): at most the cost of any path from s to t, and heuristic(s, u) <= heuristic(s, t) + heuristic(t,
///    u); 0 always serves. It must stay so when edges change: built upon the least cost an edge can ever have.
template <class G>
concept ReplanningGraph = requires(const G& graph, const typename G::State& s) {
  graph.each_out(s, [](const typename G::State&, const auto&) {});
  graph.each_in(s, [](const typename G::State&, const auto&) {});
  graph.heuristic(s, s);
};

/// A graph whose states are the numbers 0 .. state_count() - 1, which stays as it is: they are found by an array and
/// not by hashing.
template <class G>
concept NumberedGraph = ReplanningGraph<G> && std::integral<typename G::State> && requires(const G& graph) {
  { graph.state_count() } -> std::convertible_to<std::size_t>;
};

namespace detail {

/// State -> a number given to it, in a hash table; in an array where the graph is numbered.
template <class Graph, class Hash>
class StateNumbers {
 public:
  explicit StateNumbers(const Graph&) {}
  /// What s has; `next` the first time.
  std::uint32_t number(const typename Graph::State& s, std::uint32_t next) {
    return numbers_.try_emplace(s, next).first->second;
  }
  void clear() { numbers_.clear(); }

 private:
  std::unordered_map<typename Graph::State, std::uint32_t, Hash> numbers_;
};

template <NumberedGraph Graph, class Hash>
class StateNumbers<Graph, Hash> {
 public:
  explicit StateNumbers(const Graph& graph) : numbers_(graph.state_count(), kUnmet) {}
  std::uint32_t number(const typename Graph::State& s, std::uint32_t next) {
    std::uint32_t& number = numbers_[static_cast<std::size_t>(s)];
    if (number == kUnmet) number = next;
    return number;
  }
  void clear() { std::fill(numbers_.begin(), numbers_.end(), kUnmet); }

 private:
  static constexpr std::uint32_t kUnmet = 0xffffffff;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace detail

}  // namespace taut
