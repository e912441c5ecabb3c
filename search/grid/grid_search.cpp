#include <taut/search/grid/grid_search.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include <taut/geometry/errors.h>
#include <taut/geometry/expects.h>
#include <taut/search/grid/detail/grid_board.h>
#include <taut/search/grid/detail/grid_estimator.h>
#include <taut/search/grid/detail/grid_place.h>
#include <taut/search/grid/detail/grid_scratch.h>

namespace taut {

namespace {

constexpr std::array<std::string_view, kGridAlgorithms> kAlgorithms{
    "bfs",     "dfs", "dijkstra", "greedy-once", "greedy", "astar", "weighted-astar", "bidirectional-astar",
    "idastar", "jps"};
constexpr std::array<std::string_view, 3> kMoves{"4", "8", "octile"};

template <typename Enum, std::size_t n>
std::optional<Enum> named(const std::array<std::string_view, n>& names, std::string_view word) {
  const auto at = std::find(names.begin(), names.end(), word);
  if (at == names.end()) return std::nullopt;
  return static_cast<Enum>(at - names.begin());
}

using Search = void (*)(detail::GridRun&);

Search search_of(GridAlgorithm algorithm) {
  switch (algorithm) {
    case GridAlgorithm::bfs: return detail::breadth_first;
    case GridAlgorithm::dfs: return detail::depth_first;
    case GridAlgorithm::bidirectional_astar: return detail::bidirectional;
    case GridAlgorithm::idastar: return detail::iterative_deepening;
    case GridAlgorithm::jps: return detail::jump_points;
    default: return detail::best_first;
  }
}

/// The cost of the move from a to b, if it is one.
std::optional<GridCost> move_cost(const OccupancyGrid& grid, GridMoves moves, GridPlace a, GridPlace b) {
  const std::int64_t dr = std::int64_t{b.row} - a.row, dc = std::int64_t{b.column} - a.column;
  if (std::max(std::abs(dr), std::abs(dc)) != 1) return std::nullopt;
  if (dr == 0 || dc == 0) return GridCost(1, 0);
  if (moves == GridMoves::four) return std::nullopt;
  const bool beside = grid.free(a.column, b.row) && grid.free(b.column, a.row);
  if (moves == GridMoves::octile && !beside) return std::nullopt;
  return GridCost(0, 1);
}

}  // namespace

std::string_view name(GridMoves moves) { return kMoves[static_cast<std::size_t>(moves)]; }
std::optional<GridMoves> grid_moves_named(std::string_view word) { return named<GridMoves>(kMoves, word); }
std::string_view name(GridAlgorithm algorithm) { return kAlgorithms[static_cast<std::size_t>(algorithm)]; }
std::optional<GridAlgorithm> grid_algorithm_named(std::string_view word) {
  return named<GridAlgorithm>(kAlgorithms, word);
}

bool finds_least_cost(const GridQuery& query, GridMoves moves) {
  switch (query.algorithm) {
    case GridAlgorithm::bfs: return moves == GridMoves::four;
    case GridAlgorithm::dijkstra: return true;
    case GridAlgorithm::astar:
    case GridAlgorithm::bidirectional_astar:
    case GridAlgorithm::idastar:
    case GridAlgorithm::jps: return consistent_everywhere(query.heuristic, moves);
    case GridAlgorithm::weighted_astar: return query.weight == 1000 && consistent_everywhere(query.heuristic, moves);
    default: return false;
  }
}

struct GridSearch::Impl {
  detail::GridBoard board;
  detail::GridScratch scratch;
};

GridSearch::GridSearch(const OccupancyGrid& grid, GridMoves moves)
    : impl_(new Impl{detail::GridBoard(grid, moves), {}}) {}
GridSearch::GridSearch(GridSearch&&) noexcept = default;
GridSearch& GridSearch::operator=(GridSearch&&) noexcept = default;
GridSearch::~GridSearch() = default;

GridMoves GridSearch::moves() const { return impl_->board.moves(); }

GridResult GridSearch::find(GridPlace start, GridPlace goal, const GridQuery& query) {
  TAUT_EXPECTS(query.weight >= 1000 && query.weight <= 1'000'000);
  const detail::GridBoard& board = impl_->board;
  if (query.algorithm == GridAlgorithm::jps && board.moves() == GridMoves::four)
    throw InputError("", 0, "jump point search needs eight neighbours");
  const detail::BoardCell from = detail::free_cell(board, start, "start"), to = detail::free_cell(board, goal, "goal");
  detail::GridRun run(board, impl_->scratch, query, from, to);
  search_of(query.algorithm)(run);
  run.result.optimal = run.result.status == SearchStatus::found && finds_least_cost(query, board.moves());
  return std::move(run.result);
}

std::vector<std::optional<GridCost>> GridSearch::costs_to(GridPlace goal) {
  const detail::GridBoard& board = impl_->board;
  const std::vector<std::int64_t> keys = detail::costs_to(board, detail::free_cell(board, goal, "goal"));
  std::vector<std::optional<GridCost>> costs(std::size_t{board.width()} * board.height());
  for (std::uint32_t row = 0; row < board.height(); ++row)
    for (std::uint32_t column = 0; column < board.width(); ++column)
      if (const std::int64_t key = keys[board.cell({row, column})]; key != detail::kUnreached)
        costs[std::size_t{row} * board.width() + column] = GridCost::of_key(key);
  return costs;
}

GridPathVerdict verify_grid_path(const OccupancyGrid& grid, GridMoves moves, GridPlace start, GridPlace goal,
                                 const std::vector<GridPlace>& path) {
  if (path.empty()) return {"the path is empty", {}};
  if (path.front() != start) return {"the path begins at " + detail::text(path.front()), {}};
  if (path.back() != goal) return {"the path ends at " + detail::text(path.back()), {}};
  GridCost cost;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!grid.free(path[i].column, path[i].row)) return {detail::text(path[i]) + " is not free", {}};
    if (i == 0) continue;
    const std::optional<GridCost> step = move_cost(grid, moves, path[i - 1], path[i]);
    if (!step) return {detail::text(path[i - 1]) + " to " + detail::text(path[i]) + " is not a move", {}};
    cost = cost + *step;
  }
  return {"", cost};
}

}  // namespace taut
