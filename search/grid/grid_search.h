// Searches on grids, side by side: what each takes out of its frontier, in which order, and what it finds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/occupancy_grid.h>
#include <taut/search/grid/grid_cost.h>
#include <taut/search/grid/grid_heuristics.h>
#include <taut/search/grid/grid_moves.h>
#include <taut/search/search_status.h>

namespace taut {

/// A cell is *taken* when it leaves the frontier and is marked. All stop when the goal is taken, except as said.
///
///  bfs             first in, first out. Fewest moves; the least cost with four neighbours.
///  dfs             the recursive pre-order: the first neighbour not yet marked is taken next.
///  dijkstra        the least cost g first.
///  greedy_once     the least estimate h first.
///  greedy          the same with a careless frontier: a cell that is not marked goes in each time it is seen, and is
///                  taken, counted and looked around from each time it comes out, so that steps can grow exponentially.
///                  To be seen beside A*, for which it is sometimes taken.
///  astar           the least f = g + h first.
///  weighted_astar  the least f = g + w h first (w h rounded down to the unit of GridCost): at most w times the least
///                  cost when h is consistent.
///  bidirectional_astar  A* from both ends, h to the other end, the smaller frontier next (start's at a tie); stops
///                       when no cost below that of
///                  the best meeting is possible any more: max(least f of either side) >= that cost.
///  idastar         depth first within a bound on f, raised to the least f above it. A table keeps the cheapest g of
///                  this round, so that no cell is expanded twice at the same g. Every taking counts, those of earlier
///                  rounds too.
///  jps             jump point search (Harabor and Grastien, "Online graph pruning for pathfinding on grid maps", 2011)
///                  for eight neighbours; with the octile rule the pruning of "The JPS pathfinding system" (2012):
///                  diagonal moves force nothing, straight ones force a side whose cell one step back is blocked. Steps
///                  are jump points.
///
/// Among equals the one that entered first (Ties::fifo) or last (lifo). A cell enters anew when a cheaper way to it is
/// found; the old entry is void. dijkstra, astar, bidirectional_astar, idastar and jps find the least cost when the
/// heuristic is consistent.
enum class GridAlgorithm {
  bfs,
  dfs,
  dijkstra,
  greedy_once,
  greedy,
  astar,
  weighted_astar,
  bidirectional_astar,
  idastar,
  jps
};

inline constexpr std::size_t kGridAlgorithms = 10;

/// `bfs`, `greedy`, `weighted-astar`, ...
std::string_view name(GridAlgorithm algorithm);
/// Nothing for any other word.
std::optional<GridAlgorithm> grid_algorithm_named(std::string_view word);

/// Of equal entries of the frontier, which one is taken: the one that came first, or last.
enum class Ties { fifo, lifo };

/// How to search.
struct GridQuery {
  GridAlgorithm algorithm = GridAlgorithm::astar;
  GridHeuristic heuristic;  ///< bfs, dfs and dijkstra do without
  Ties ties = Ties::fifo;
  std::uint32_t weight = 1500;  ///< of weighted_astar, in thousandths, 1000 to 1'000'000
  std::size_t max_steps = SIZE_MAX;
  bool record = false;  ///< keep `visited` and `frontier`
};

/// The answer, and what it took.
struct GridResult {
  SearchStatus status = SearchStatus::none;
  std::size_t steps = 0;    ///< cells taken, start and goal included, each once (but for greedy and idastar)
  std::size_t entered = 0;  ///< entries put into the frontier, the start included
  std::size_t rounds = 1;   ///< of idastar
  GridCost cost;
  std::vector<GridPlace> path;      ///< all cells from start to goal, both included; empty unless found
  bool optimal = false;             ///< proven: no path costs less
  std::vector<GridPlace> visited;   ///< when recorded: cells in the order of their first taking
  std::vector<GridPlace> frontier;  ///< when recorded: cells seen and not taken, by rows
};

/// Does this query find the least cost, whatever the map?
bool finds_least_cost(const GridQuery& query, GridMoves moves);

/// Searches on one map. Memory is kept from query to query and not cleared (generation stamps), so that a query costs
/// what it looks at. Not for several threads at once.
class GridSearch {
 public:
  /// Throws InputError when the grid has no cell, more than 4 * 10^8, or not width * height of them.
  GridSearch(const OccupancyGrid& grid, GridMoves moves);
  GridSearch(const GridSearch&) = delete;
  GridSearch(GridSearch&&) noexcept;
  GridSearch& operator=(GridSearch&&) noexcept;
  ~GridSearch();

  GridMoves moves() const;

  /// Throws InputError when start or goal lies outside or is blocked, and for jps with four neighbours.
  GridResult find(GridPlace start, GridPlace goal, const GridQuery& query);

  /// The least cost from every cell to `goal`, by rows; nothing where there is no way. Throws InputError as above.
  std::vector<std::optional<GridCost>> costs_to(GridPlace goal);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Replays a path against the map alone: begins and ends right, every move is one of `moves`; gives its cost, or what
/// is wrong.
struct GridPathVerdict {
  std::string fault;  ///< empty: valid
  GridCost cost;
};
GridPathVerdict verify_grid_path(const OccupancyGrid& grid, GridMoves moves, GridPlace start, GridPlace goal,
                                 const std::vector<GridPlace>& path);

}  // namespace taut
