// How a Roadmap is searched: an algorithm, and what it believes is left to the goal.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace taut {

/// What is taken from the queue next, and what a vertex then is worth.
enum class GraphAlgorithm {
  astar,     ///< least length so far plus estimate; a vertex reached by a shorter way later is opened again
  dijkstra,  ///< least length so far
  bfs,       ///< first in, first out: a path with the fewest legs, of whatever length
  dfs,       ///< on from the vertex found last, along its legs in the order of the graph: some path
  greedy,    ///< least estimate; the first way found to a vertex stays
};

/// An estimate of the length from a point to the nearest goal, with dx and dy the distances of the coordinates. A
/// straight leg is never longer than what Manhattan or octile say of its ends, but mostly shorter: on a graph of such
/// legs these two overestimate, and A* with them can miss the shortest path. The other three never do.
enum class GraphHeuristic {
  euclidean,  ///< sqrt(dx^2 + dy^2)
  manhattan,  ///< dx + dy
  octile,     ///< sqrt(2) min(dx, dy) + |dx - dy|
  chebyshev,  ///< max(dx, dy)
  zero,       ///< 0: A* is Dijkstra then
};

struct GraphMethod {
  GraphAlgorithm algorithm = GraphAlgorithm::astar;
  GraphHeuristic heuristic = GraphHeuristic::euclidean;  ///< of astar and greedy; the others have none

  GraphMethod() = default;
  GraphMethod(GraphAlgorithm a, GraphHeuristic h = GraphHeuristic::euclidean) : algorithm(a), heuristic(h) {}

  friend bool operator==(const GraphMethod&, const GraphMethod&) = default;
};

/// astar and greedy.
bool uses_heuristic(GraphAlgorithm algorithm);
/// Is the path found the shortest in every graph of straight legs? dijkstra, and astar with euclidean, chebyshev or
/// zero.
bool optimal_everywhere(GraphMethod method);

/// `astar`, `manhattan`; the names of all, joined by commas; nothing for a word that names none.
std::string_view name(GraphAlgorithm algorithm);
std::string_view name(GraphHeuristic heuristic);
std::string name(GraphMethod method);  ///< `dijkstra`, `astar with manhattan`
std::string graph_algorithm_names();
std::string graph_heuristic_names();
std::optional<GraphAlgorithm> graph_algorithm_named(std::string_view word);
std::optional<GraphHeuristic> graph_heuristic_named(std::string_view word);

}  // namespace taut
