#include <taut/search/graph_method.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace taut {

namespace {

// In the order of the enumerations.
constexpr std::array<std::string_view, 5> kAlgorithms{"astar", "dijkstra", "bfs", "dfs", "greedy"};
constexpr std::array<std::string_view, 5> kHeuristics{"euclidean", "manhattan", "octile", "chebyshev", "zero"};

using Names = std::array<std::string_view, 5>;

std::string joined(const Names& names) {
  std::string all;
  for (const std::string_view name : names) all.append(all.empty() ? "" : ", ").append(name);
  return all;
}

template <class Value>
std::optional<Value> named(const Names& names, std::string_view word) {
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) return std::nullopt;
  return static_cast<Value>(found - names.begin());
}

}  // namespace

bool uses_heuristic(GraphAlgorithm algorithm) {
  return algorithm == GraphAlgorithm::astar || algorithm == GraphAlgorithm::greedy;
}

bool optimal_everywhere(GraphMethod method) {
  if (method.algorithm != GraphAlgorithm::astar) return method.algorithm == GraphAlgorithm::dijkstra;
  return method.heuristic != GraphHeuristic::manhattan && method.heuristic != GraphHeuristic::octile;
}

std::string_view name(GraphAlgorithm algorithm) { return kAlgorithms[static_cast<std::size_t>(algorithm)]; }
std::string_view name(GraphHeuristic heuristic) { return kHeuristics[static_cast<std::size_t>(heuristic)]; }

std::string name(GraphMethod method) {
  std::string text(name(method.algorithm));
  if (uses_heuristic(method.algorithm)) text.append(" with ").append(name(method.heuristic));
  return text;
}

std::string graph_algorithm_names() { return joined(kAlgorithms); }
std::string graph_heuristic_names() { return joined(kHeuristics); }

std::optional<GraphAlgorithm> graph_algorithm_named(std::string_view word) {
  return named<GraphAlgorithm>(kAlgorithms, word);
}
std::optional<GraphHeuristic> graph_heuristic_named(std::string_view word) {
  return named<GraphHeuristic>(kHeuristics, word);
}

}  // namespace taut
