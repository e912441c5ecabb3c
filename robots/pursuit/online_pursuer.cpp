#include <taut/robots/pursuit/online_pursuer.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/robots/pursuit/detail/hops.h>
#include <taut/robots/pursuit/exact_planner.h>

namespace taut::pursuit {

namespace {

constexpr int kPatience = 16;  // parts of a way after which it is looked at again

int distance(const ChaseMap& map, CellIndex a, CellIndex b) {
  const Cell p = map.cell(a), q = map.cell(b);
  return std::max(std::abs(p.x - q.x), std::abs(p.y - q.y));
}

}  // namespace

Unfolding::Unfolding(const ChaseMap& map, Clock clock, int horizon)
    : map_(map), first_(clock == Clock::one ? 1 : 0), horizon_(horizon) {
  TAUT_EXPECTS(horizon >= 0);
}

TargetSighting Unfolding::at(int now) const {
  TargetSighting sight{now, {}};
  const std::int64_t end =
      std::min<std::int64_t>(first_ + static_cast<std::int64_t>(map_.duration()), std::int64_t{now} + horizon_ + 1);
  for (int second = std::max(now, first_); second < end; ++second)
    sight.seen.push_back({map_.target()[static_cast<std::size_t>(second - first_)], second});
  return sight;
}

OnlinePursuer::OnlinePursuer(const ChaseMap& ground, PlanLimits limits)
    : ground_(ground),
      limits_(std::move(limits)),
      cheapest_(*std::min_element(ground.costs().begin(), ground.costs().end())) {}

CellIndex OnlinePursuer::next(CellIndex at, const TargetSighting& sight) {
  if (!is_on_way(at, sight.now)) {
    way_.clear();
    is_sure_ = false;
    due_ = sight.now;
  }
  if (!is_sure_ || (sight.now >= due_ && could_be_cheaper(sight))) look_for_meeting(at, sight);
  if (!is_sure_) head_for_target(at, sight);
  return is_on_way(at, sight.now) ? follow(sight.now) : at;
}

bool OnlinePursuer::is_on_way(CellIndex at, int now) const {
  const auto passed = static_cast<std::size_t>(now - begin_);
  return passed + 1 < way_.size() && way_[passed] == at;
}

void OnlinePursuer::set_way(std::vector<CellIndex> way, int now, bool is_sure) {
  ++plans_;
  due_ = now + std::max(1, static_cast<int>(way.size()) / kPatience);
  way_ = std::move(way);
  begin_ = now;
  is_sure_ = is_sure;
}

// Meetings that were not seen before are later than all others.
bool OnlinePursuer::could_be_cheaper(const TargetSighting& sight) const {
  if (sight.seen.empty() || sight.seen.back().second <= known_) return false;
  Cost rest = 0;
  for (std::size_t i = static_cast<std::size_t>(sight.now - begin_); i + 1 < way_.size(); ++i)
    rest += ground_.cost(way_[i]);
  return Cost{std::max(known_, sight.now) + 1 - sight.now} * cheapest_ < rest;
}

void OnlinePursuer::look_for_meeting(CellIndex at, const TargetSighting& sight) {
  Chase chase{&ground_, at, sight.now, {}};
  for (const Meeting& m : sight.seen)
    if (m.second > sight.now && ground_.is_free(m.cell)) chase.meetings.push_back(m);
  // The robot cannot be farther from all of them than there are seconds.
  const bool is_near = std::any_of(chase.meetings.begin(), chase.meetings.end(), [&](const Meeting& m) {
    return distance(ground_, at, m.cell) <= m.second - sight.now;
  });
  if (!is_near) return;
  const ChasePlan plan = exact_plan(chase, limits_);
  if (plan.status != SearchStatus::found) return;
  known_ = sight.seen.back().second;
  Cost rest = 0;
  if (is_sure_)
    for (std::size_t i = static_cast<std::size_t>(sight.now - begin_); i + 1 < way_.size(); ++i)
      rest += ground_.cost(way_[i]);
  if (is_sure_ && rest <= plan.cost)
    due_ = sight.now + std::max(1, static_cast<int>(plan.cells.size()) / kPatience);
  else
    set_way(plan.cells, sight.now, true);
}

// The first cell of the line ahead that the robot could be at in time, were there no obstacles; else the last.
CellIndex OnlinePursuer::expected(CellIndex at, const TargetSighting& sight) {
  const Meeting last = sight.seen.back();
  std::ptrdiff_t step = 0;
  if (sight.seen.size() > 1)
    step = static_cast<std::ptrdiff_t>(last.cell) - static_cast<std::ptrdiff_t>(sight.seen[sight.seen.size() - 2].cell);
  else if (last_seen_)
    step = static_cast<std::ptrdiff_t>(last.cell) - static_cast<std::ptrdiff_t>(*last_seen_);
  const auto steps = detail::neighbour_steps(ground_);
  if (std::find(steps.begin(), steps.end(), step) == steps.end()) step = 0;
  CellIndex cell = last.cell;
  for (int second = last.second; distance(ground_, at, cell) > second - sight.now; ++second) {
    const auto ahead = static_cast<CellIndex>(static_cast<std::ptrdiff_t>(cell) + step);
    if (step == 0 || !ground_.is_free(ahead)) break;
    cell = ahead;
  }
  return cell;
}

void OnlinePursuer::head_for_target(CellIndex at, const TargetSighting& sight) {
  if (sight.seen.empty()) return;
  const CellIndex goal = expected(at, sight);
  last_seen_ = sight.seen.back().cell;
  if (!ground_.is_free(goal) || goal == at) return;
  const bool is_news = goal != expected_;
  expected_ = goal;
  if (is_on_way(at, sight.now) && (!is_news || sight.now < due_)) return;
  set_way(detail::cheapest_way(ground_, at, goal), sight.now, false);
}

}  // namespace taut::pursuit
