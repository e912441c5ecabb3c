#include <taut/search/grid/detail/grid_estimator.h>

#include <cmath>
#include <queue>
#include <utility>

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
  if (members_ == std::vector{GridEstimate::zero}) members_.clear();
  if (has(GridEstimate::exact)) exact_ = costs_to(board, target);
}

}  // namespace taut::detail
