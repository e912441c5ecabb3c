#include <algorithm>

#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

CostToMeet::CostToMeet(Worker& worker, Cost u, std::uint32_t lo, const std::vector<Meeting>& meetings,
                       const std::vector<int>& latest)
    : u_(u), base_(kNoCost), cost_(worker.work.map().index_count()) {
  const Workspace& work = worker.work;
  const ChaseMap& map = work.map();
  RadixHeap<CellIndex> queue;
  for (const Meeting& m : meetings) base_ = std::min(base_, u * work.seconds(m));
  const auto most = static_cast<std::uint64_t>(std::max<Cost>(0, work.parts * worker.upper() - base_));
  const auto enter = [&](CellIndex c, std::uint64_t cost) {
    if (cost >= most || cost >= cost_[c] || latest[c] < 0) return;
    cost_.set(c, cost);
    queue.push(cost, c);
  };
  for (const Meeting& m : meetings)
    if (map.cost(m.cell) >= lo) enter(m.cell, static_cast<std::uint64_t>(u * work.seconds(m) - base_));
  ++worker.effort.searches;
  for (std::size_t since = 0; !queue.empty();) {
    const auto [cost, cell] = queue.pop();
    if (cost != cost_[cell]) continue;
    worker.count(since);
    for (const std::ptrdiff_t step : work.steps) {
      const CellIndex before = work.neighbour(cell, step);
      if (map.is_free(before) && map.cost(before) >= lo)
        enter(before, cost + static_cast<std::uint64_t>(work.parts * map.cost(before) - u));
    }
  }
}

}  // namespace taut::pursuit::detail
