// Evaluates a GridHeuristic, in units of GridCost.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include <taut/search/grid/detail/grid_board.h>
#include <taut/search/grid/grid_heuristics.h>

namespace taut::detail {

inline constexpr std::int64_t kUnreached = std::numeric_limits<std::int64_t>::max() / 4;

/// floor(kStraight * sqrt(square)), exactly, for square < 2^62.
std::int64_t scaled_root(std::uint64_t square);

/// Least costs to `target` by cell of the board, kUnreached where there is no way.
std::vector<std::int64_t> costs_to(const GridBoard& board, BoardCell target);

class GridEstimator {
 public:
  /// Runs the backwards search when `exact` is among the members, and evaluates formulas in all free cells. The board
  /// must outlive it. Throws InputError where the value of a formula is refused.
  GridEstimator(const GridBoard& board, const GridHeuristic& heuristic, BoardCell target);

  /// kUnreached where the exact estimate knows that there is no way.
  std::int64_t operator()(BoardCell c) const {
    if (members_.empty()) return formulas_.empty() ? 0 : formulas_[c];
    const GridPlace p = board_.place(c);
    const std::int64_t dr = std::int64_t{p.row} - target_.row, dc = std::int64_t{p.column} - target_.column;
    std::int64_t most = value(members_.front(), dr, dc, c);
    if (!formulas_.empty()) most = std::max(most, formulas_[c]);
    for (std::size_t i = 1; i < members_.size(); ++i) most = std::max(most, value(members_[i], dr, dc, c));
    return most;
  }

 private:
  std::int64_t value(GridEstimate estimate, std::int64_t dr, std::int64_t dc, BoardCell c) const {
    const std::int64_t rows = std::abs(dr), columns = std::abs(dc);
    const std::int64_t more = std::max(rows, columns), less = std::min(rows, columns);
    switch (estimate) {
      case GridEstimate::zero: return 0;
      case GridEstimate::manhattan: return (rows + columns) * GridCost::kStraight;
      case GridEstimate::euclidean: return scaled_root(static_cast<std::uint64_t>(dr * dr + dc * dc));
      case GridEstimate::chebyshev: return more * GridCost::kStraight;
      case GridEstimate::octile: return (more - less) * GridCost::kStraight + less * GridCost::kDiagonal;
      case GridEstimate::biased_row: return dr * GridCost::kStraight;
      case GridEstimate::biased_column: return dc * GridCost::kStraight;
      case GridEstimate::exact: return exact_[c];
    }
    return 0;
  }

  std::int64_t formula(const GridFormula& f, BoardCell c) const;

  const GridBoard& board_;
  std::vector<GridEstimate> members_;  // none for zero alone, or formulas alone
  GridPlace target_;
  std::vector<std::int64_t> exact_, formulas_;  // by cell, where there are any
};

}  // namespace taut::detail
