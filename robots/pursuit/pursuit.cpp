#include <taut/robots/pursuit/pursuit.h>

#include <algorithm>

#include <taut/geometry/text.h>
#include <taut/robots/pursuit/detail/hops.h>

namespace taut::pursuit {

std::vector<Meeting> meetings_of(const ChaseMap& map, Clock clock) {
  std::vector<Meeting> meetings;
  const std::size_t shift = clock == Clock::one ? 1 : 0;
  for (std::size_t i = 0; i < map.duration(); ++i)
    if (i + shift >= 1 && map.is_free(map.target()[i]))
      meetings.push_back({map.target()[i], static_cast<int>(i + shift)});
  return meetings;
}

Chase chase_of(const ChaseMap& map, Clock clock) { return {&map, map.start(), 0, meetings_of(map, clock)}; }

std::string reason_of_failure(const Chase& chase) {
  const auto first = std::find_if(chase.meetings.begin(), chase.meetings.end(),
                                  [&](const Meeting& m) { return m.second > chase.now; });
  if (chase.meetings.empty() && chase.map->duration() > 1) return "the target is inside obstacles all the time";
  if (first == chase.meetings.end())
    return chase.map->duration() == 1 ? "the trajectory is too short: its only entry is where the target begins"
                                      : "the target has gone, or is inside obstacles for the rest of its trajectory";
  const std::vector<int> hops = detail::hops_from(*chase.map, chase.from, detail::kNoLimit);
  int least = detail::kUnreachable, lateness = detail::kUnreachable;
  for (auto m = first; m != chase.meetings.end(); ++m) {
    least = std::min(least, hops[m->cell]);
    if (hops[m->cell] != detail::kUnreachable) lateness = std::min(lateness, hops[m->cell] - (m->second - chase.now));
  }
  if (least == detail::kUnreachable) return "obstacles separate the target's whole trajectory from the robot";
  return "the trajectory is too short: the robot comes at least " + std::to_string(lateness) +
         (lateness == 1 ? " second late" : " seconds late") + " to each of its cells";
}

namespace {

std::string fault_of_step(const Chase& chase, CellIndex from, CellIndex to) {
  const Cell a = chase.map->cell(from), b = chase.map->cell(to);
  if (std::abs(a.x - b.x) > 1 || std::abs(a.y - b.y) > 1)
    return "the move from " + taut::text(a) + " to " + taut::text(b) + " is no step to a neighbour";
  return chase.map->is_free(to) ? "" : "the move to " + taut::text(b) + " ends in an obstacle";
}

bool is_meeting(const Chase& chase, CellIndex cell, int second) {
  const auto found = std::lower_bound(chase.meetings.begin(), chase.meetings.end(), second,
                                      [](const Meeting& m, int s) { return m.second < s; });
  return found != chase.meetings.end() && found->second == second && found->cell == cell;
}

}  // namespace

std::string verify_plan(const ChasePlan& plan, const Chase& chase) {
  if (plan.status != SearchStatus::found) return plan.cells.empty() ? "" : "a way, but the status is not `found`";
  if (plan.cells.size() < 2 || plan.cells.front() != chase.from) return "the way does not begin at the robot";
  Cost cost = 0;
  for (std::size_t i = 0; i + 1 < plan.cells.size(); ++i) {
    if (plan.cells[i + 1] >= chase.map->index_count()) return "a cell that is not on the map";
    if (std::string fault = fault_of_step(chase, plan.cells[i], plan.cells[i + 1]); !fault.empty()) return fault;
    cost += chase.map->cost(plan.cells[i]);
    const bool last = i + 2 == plan.cells.size();
    if (is_meeting(chase, plan.cells[i + 1], chase.now + static_cast<int>(i) + 1) != last)
      return last ? "the way does not end at the target" : "the way goes on after it met the target";
  }
  if (cost != plan.cost) return "the way costs " + std::to_string(cost) + " units, not " + std::to_string(plan.cost);
  return plan.bound > plan.cost || (plan.optimal && plan.bound != plan.cost) ? "the bound is wrong" : "";
}

}  // namespace taut::pursuit
