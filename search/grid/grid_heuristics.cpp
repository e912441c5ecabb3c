#include <taut/search/grid/grid_heuristics.h>

#include <algorithm>
#include <array>

#include <taut/geometry/errors.h>
#include <taut/search/grid/detail/grid_estimator.h>
#include <taut/search/grid/detail/grid_place.h>

namespace taut {

namespace {

constexpr std::array<std::string_view, 8> kNames{"zero",   "manhattan",  "euclidean",     "chebyshev",
                                                 "octile", "biased-row", "biased-column", "exact"};

std::optional<GridEstimate> estimate_named(std::string_view word) {
  const auto at = std::find(kNames.begin(), kNames.end(), word);
  if (at == kNames.end()) return std::nullopt;
  return static_cast<GridEstimate>(at - kNames.begin());
}

double units(std::int64_t estimate) { return static_cast<double>(estimate) / static_cast<double>(GridCost::kStraight); }

/// What heuristic_verdict goes through, cell by cell.
class Judge {
 public:
  Judge(const detail::GridBoard& board, const GridHeuristic& heuristic, detail::BoardCell goal)
      : board_(board), h_(board, heuristic, goal), cost_(detail::costs_to(board, goal)), goal_(goal) {}

  HeuristicVerdict verdict() {
    if (const std::int64_t at_goal = h_(goal_); at_goal != 0) {
      worst_violation_ = std::abs(at_goal);
      verdict_.violation = {board_.place(goal_), board_.place(goal_), units(at_goal), units(at_goal), {}};
    }
    for (std::uint32_t row = 0; row < board_.height(); ++row)
      for (std::uint32_t column = 0; column < board_.width(); ++column) look(board_.cell({row, column}));
    return verdict_;
  }

 private:
  void look(detail::BoardCell c) {
    if (cost_[c] == detail::kUnreached) return;
    ++verdict_.cells;
    const std::int64_t h = h_(c);
    if (h - cost_[c] > worst_excess_) {
      worst_excess_ = h - cost_[c];
      verdict_.overestimate = {board_.place(c), units(h), GridCost::of_key(cost_[c])};
    }
    board_.for_neighbours(c, [&](unsigned move, detail::BoardCell n) {
      const std::int64_t fall = h - h_(n) - detail::GridBoard::cost(move);
      if (fall <= worst_violation_) return;
      worst_violation_ = fall;
      verdict_.violation = {board_.place(c), board_.place(n), units(h), units(h_(n)),
                            GridCost::of_key(detail::GridBoard::cost(move))};
    });
  }

  const detail::GridBoard& board_;
  detail::GridEstimator h_;
  std::vector<std::int64_t> cost_;
  detail::BoardCell goal_;
  HeuristicVerdict verdict_;
  std::int64_t worst_excess_ = 0;
  std::int64_t worst_violation_ = 0;
};

}  // namespace

std::string_view name(GridEstimate estimate) { return kNames[static_cast<std::size_t>(estimate)]; }

std::string name(const GridHeuristic& heuristic) {
  std::string names;
  for (const GridEstimate e : heuristic.members) names.append(names.empty() ? "" : ",").append(name(e));
  for (const GridFormula& f : heuristic.formulas) names.append(names.empty() ? "" : ",").append(f.text);
  return names.empty() ? "zero" : names;
}

std::optional<GridHeuristic> grid_heuristic_named(std::string_view words) {
  GridHeuristic heuristic{{}};
  for (std::size_t from = 0; from <= words.size();) {
    const std::size_t comma = std::min(words.find(',', from), words.size());
    const auto estimate = estimate_named(words.substr(from, comma - from));
    if (!estimate) return std::nullopt;
    heuristic.members.push_back(*estimate);
    from = comma + 1;
  }
  return heuristic;
}

std::string grid_estimate_names() {
  std::string names;
  for (const std::string_view each : kNames) names.append(names.empty() ? "" : ", ").append(each);
  return names;
}

GridHeuristic natural_heuristic(GridMoves moves) {
  return {{moves == GridMoves::four ? GridEstimate::manhattan : GridEstimate::octile}};
}

bool consistent_everywhere(const GridHeuristic& heuristic, GridMoves moves) {
  const auto& all = heuristic.members;
  if (!heuristic.formulas.empty()) return false;
  return moves == GridMoves::four || std::find(all.begin(), all.end(), GridEstimate::manhattan) == all.end();
}

HeuristicVerdict heuristic_verdict(const OccupancyGrid& grid, GridMoves moves, GridPlace goal,
                                   const GridHeuristic& heuristic) {
  const detail::GridBoard board(grid, moves);
  return Judge(board, heuristic, detail::free_cell(board, goal, "goal")).verdict();
}

}  // namespace taut
