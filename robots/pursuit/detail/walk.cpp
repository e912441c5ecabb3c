#include <taut/robots/pursuit/detail/walk.h>

#include <algorithm>

namespace taut::pursuit::detail {

WayCost cost_of(const ChaseMap& map, const std::vector<CellIndex>& way) {
  WayCost cost{0, map.cost(way.back())};
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    cost.moves += map.cost(way[i]);
    cost.least = std::min(cost.least, map.cost(way[i]));
  }
  return cost;
}

ChasePlan plan_along(const Chase& chase, const std::vector<CellIndex>& way, int seconds) {
  const ChaseMap& map = *chase.map;
  const auto rest =
      std::min_element(way.begin(), way.end(), [&](CellIndex a, CellIndex b) { return map.cost(a) < map.cost(b); });
  ChasePlan plan;
  plan.status = SearchStatus::found;
  plan.cells.reserve(static_cast<std::size_t>(seconds) + 1);
  plan.cells.assign(way.begin(), rest);
  plan.cells.insert(plan.cells.end(), static_cast<std::size_t>(seconds) + 2 - way.size(), *rest);
  plan.cells.insert(plan.cells.end(), rest + 1, way.end());
  for (const Meeting& m : chase.meetings) {
    const int at = m.second - chase.now;
    if (at > seconds) break;
    if (at < 1 || plan.cells[static_cast<std::size_t>(at)] != m.cell) continue;
    plan.cells.resize(static_cast<std::size_t>(at) + 1);
    break;
  }
  for (std::size_t i = 0; i + 1 < plan.cells.size(); ++i) plan.cost += map.cost(plan.cells[i]);
  return plan;
}

}  // namespace taut::pursuit::detail
