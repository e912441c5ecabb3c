#include <taut/search/grid/detail/grid_estimator.h>

#include <cmath>
#include <queue>
#include <string>
#include <utility>

#include <taut/geometry/errors.h>

namespace taut::detail {

std::int64_t scaled_root(std::uint64_t square) {
  __extension__ using Wide = unsigned __int128;
  constexpr auto kUnit = static_cast<std::uint64_t>(GridCost::kStraight);
  const Wide wanted = Wide{square} * (Wide{kUnit} * kUnit);
  auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(square)) * static_cast<double>(kUnit));
  while (Wide{root} * root > wanted) --root;
  while (Wide{root + 1} * (root + 1) <= wanted) ++root;
  return static_cast<std::int64_t>(root);
}

std::vector<std::int64_t> costs_to(const GridBoard& board, BoardCell target) {
  using Entry = std::pair<std::int64_t, BoardCell>;
  std::vector<std::int64_t> cost(board.size(), kUnreached);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[target] = 0;
  open.emplace(0, target);
  while (!open.empty()) {
    const auto [g, c] = open.top();
    open.pop();
    if (g > cost[c]) continue;
    board.for_neighbours(c, [&, from = g](unsigned move, BoardCell n) {
      const std::int64_t through = from + GridBoard::cost(move);
      if (through >= cost[n]) return;
      cost[n] = through;
      open.emplace(through, n);
    });
  }
  return cost;
}

GridEstimator::GridEstimator(const GridBoard& board, const GridHeuristic& heuristic, BoardCell target)
    : board_(board), members_(heuristic.members), target_(board.place(target)) {
  const auto has = [&](GridEstimate e) { return std::find(members_.begin(), members_.end(), e) != members_.end(); };
  if (members_ == std::vector{GridEstimate::zero} && heuristic.formulas.empty()) members_.clear();
  if (has(GridEstimate::exact)) exact_ = costs_to(board, target);
  if (heuristic.formulas.empty()) return;
  formulas_.resize(board.size());
  for (BoardCell c = 0; c < board.size(); ++c) {
    if (!board.free(c)) continue;
    formulas_[c] = std::numeric_limits<std::int64_t>::min();
    for (const GridFormula& f : heuristic.formulas) formulas_[c] = std::max(formulas_[c], formula(f, c));
  }
}

std::int64_t GridEstimator::formula(const GridFormula& f, BoardCell c) const {
  const GridPlace place = board_.place(c);
  const double value = f.value(place, target_);
  if (!(std::abs(value) <= GridFormula::kLargest))
    throw InputError("", 0,
                     "the estimate " + f.text + " has no value up to 1e9 in cell (" + std::to_string(place.row) + "," +
                         std::to_string(place.column) + ")");
  return std::llround(value * static_cast<double>(GridCost::kStraight));
}

}  // namespace taut::detail
