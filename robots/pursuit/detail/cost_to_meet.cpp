#include <algorithm>
#include <bit>

#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

CostToMeet::CostToMeet(Worker& worker, std::int64_t u, std::uint32_t lo, const std::vector<Meeting>& meetings,
                       const std::vector<int>& latest)
    : work_(worker.work), u_(u), key_(work_.map().index_count(), kFar) {
  const Workspace& work = work_;
  const ChaseMap& map = work.map();
  RadixHeap<CellIndex> queue;
  base_ = kNoCost;
  for (const Meeting& m : meetings) base_ = std::min(base_, u * work.seconds(m));
  const auto most = static_cast<std::uint64_t>(std::max<Cost>(0, worker.upper() - base_));
  const auto enter = [&](CellIndex c, std::uint64_t cost, std::uint64_t moves) {
    if (cost >= most || latest[c] < 0) return;
    const std::uint64_t key = (cost << work.bits) | moves;
    if (key >= key_[c]) return;
    key_[c] = key;
    queue.push(key, c);
  };
  for (const Meeting& m : meetings)
    if (map.cost(m.cell) >= lo) enter(m.cell, static_cast<std::uint64_t>(u * work.seconds(m) - base_), 0);
  ++worker.effort.searches;
  const std::uint64_t most_moves = (std::uint64_t{1} << work.bits) - 1;
  for (std::size_t since = 0; !queue.empty();) {
    const auto [key, cell] = queue.pop();
    if (key != key_[cell]) continue;
    worker.count(since);
    const std::uint64_t cost = key >> work.bits, moves = std::min((key & most_moves) + 1, most_moves);
    for (const std::ptrdiff_t step : work.steps) {
      const CellIndex before = work.neighbour(cell, step);
      if (map.is_free(before) && map.cost(before) >= lo)
        enter(before, cost + static_cast<std::uint64_t>(std::int64_t{map.cost(before)} - u), moves);
    }
  }
}

CostToMeet::Way CostToMeet::way(CellIndex from, const std::vector<Meeting>& meetings) const {
  const std::uint64_t most_moves = (std::uint64_t{1} << work_.bits) - 1;
  Way way{{from}, -1};
  while ((key_[way.cells.back()] & most_moves) != 0) {
    const CellIndex cell = way.cells.back();
    const std::uint64_t reduced = static_cast<std::uint64_t>(std::int64_t{work_.map().cost(cell)} - u_);
    const std::uint64_t rest = key_[cell] - (reduced << work_.bits) - 1;
    const auto step = std::find_if(work_.steps.begin(), work_.steps.end(),
                                   [&](std::ptrdiff_t s) { return key_[work_.neighbour(cell, s)] == rest; });
    if (step == work_.steps.end()) return way;  // longer than keys can count: no way in time
    way.cells.push_back(work_.neighbour(cell, *step));
  }
  const CellIndex end = way.cells.back();
  const auto moves = static_cast<int>(way.cells.size()) - 1;
  for (const Meeting& m : meetings)
    if (m.cell == end && u_ * work_.seconds(m) == at(end) && way.seconds < moves) way.seconds = work_.seconds(m);
  return way;
}

}  // namespace taut::pursuit::detail
