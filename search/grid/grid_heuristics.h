// Estimates of the cost to the goal on a grid, and what is true of them on a given map.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/occupancy_grid.h>
#include <taut/search/grid/grid_cost.h>
#include <taut/search/grid/grid_moves.h>

namespace taut {

/// With dy = row - goal row and dx = column - goal column:
enum class GridEstimate {
  zero,           ///< 0
  manhattan,      ///< |dx| + |dy|
  euclidean,      ///< sqrt(dx^2 + dy^2), rounded down to a multiple of 1 / GridCost::kStraight; the others are exact
  chebyshev,      ///< max(|dx|, |dy|)
  octile,         ///< sqrt(2) min(|dx|, |dy|) + the rest
  biased_row,     ///< dy, negative above the goal
  biased_column,  ///< dx, negative left of the goal
  exact,          ///< the true cost, by a search backwards from the goal over the whole map before the search proper
};

/// An estimate of one's own, rounded to the nearest multiple of 1 / GridCost::kStraight (2e-9).
struct GridFormula {
  /// Larger values, infinite ones and those that are no number are refused.
  static constexpr double kLargest = 1e9;

  std::string text;  ///< stands for it where two are compared or it is named
  std::function<double(GridPlace cell, GridPlace goal)> value;

  friend bool operator==(const GridFormula& a, const GridFormula& b) { return a.text == b.text; }
};

/// The maximum of a set of estimates; of none, 0. Rounding Euclidean lengths down keeps them consistent: a diagonal
/// move counts as slightly more than sqrt(2) (GridCost), a straight one as a whole number of units.
struct GridHeuristic {
  std::vector<GridEstimate> members{GridEstimate::zero};
  std::vector<GridFormula> formulas = {};

  friend bool operator==(const GridHeuristic&, const GridHeuristic&) = default;
};

/// `zero`, `manhattan`, `euclidean`, `chebyshev`, `octile`, `biased-row`, `biased-column`, `exact`; of a maximum the
/// names joined by commas.
std::string_view name(GridEstimate estimate);
std::string name(const GridHeuristic& heuristic);
/// Nothing for a word that names none.
std::optional<GridHeuristic> grid_heuristic_named(std::string_view words);
std::string grid_estimate_names();

/// Manhattan for four neighbours, else octile: the largest that is consistent on every map.
GridHeuristic natural_heuristic(GridMoves moves);

/// Consistent on every map: all but formulas, and Manhattan where moves are diagonal, and maxima with them. What is
/// consistent is admissible.
bool consistent_everywhere(const GridHeuristic& heuristic, GridMoves moves);

/// An estimate above the true cost.
struct Overestimate {
  GridPlace cell;
  double estimate = 0;
  GridCost cost;  ///< the true one
};

/// A move along which the estimate falls by more than the move costs, or the goal itself (from == to) when its estimate
/// is not 0.
struct InconsistentMove {
  GridPlace from;
  GridPlace to;
  double estimate_from = 0;
  double estimate_to = 0;
  GridCost cost;
};

/// What an estimate is worth: heuristic_verdict().
struct HeuristicVerdict {
  std::optional<Overestimate> overestimate;   ///< none: admissible. Else the largest, the first by rows among equals
  std::optional<InconsistentMove> violation;  ///< none: consistent. Else the largest, the first by rows among equals
  std::size_t cells = 0;                      ///< looked at: those from which the goal can be reached

  bool admissible() const { return !overestimate; }
  bool consistent() const { return !violation; }
};

/// Compares the estimate with the true cost in every cell that can reach the goal, and across every move between them.
/// All integers: nothing is tolerated. Throws InputError when the goal is outside or blocked, or a formula's value
/// refused. O(cells log cells).
HeuristicVerdict heuristic_verdict(const OccupancyGrid& grid, GridMoves moves, GridPlace goal,
                                   const GridHeuristic& heuristic);

}  // namespace taut
