#include <taut/robots/pursuit/exact_planner.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <memory>
#include <thread>
#include <tuple>

#include <taut/geometry/detail/expects.h>
#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit {

namespace {

using namespace detail;

/// The way that `latest` itself leads along.
void offer_earliest(Workspace& work, const std::vector<Meeting>& meetings) {
  std::vector<CellIndex> way{work.chase->from};
  const auto seconds_at = [&](CellIndex c) {
    if (work.is_target[c])
      for (const Meeting& m : meetings)
        if (m.cell == c && work.seconds(m) == work.latest[c]) return work.seconds(m);
    return -1;
  };
  int seconds = seconds_at(way.back());
  while (seconds < 0) {
    const CellIndex cell = way.back();
    for (const std::ptrdiff_t step : work.steps)
      if (work.latest[work.neighbour(cell, step)] == work.latest[cell] + 1) {
        way.push_back(work.neighbour(cell, step));
        break;
      }
    seconds = seconds_at(way.back());
  }
  work.offer(way, seconds);
}

std::vector<Meeting> to_come(const Chase& chase) {
  std::vector<Meeting> meetings;
  for (const Meeting& m : chase.meetings)
    if (m.second > chase.now) meetings.push_back(m);
  return meetings;
}

/// Ranges of the cheapest cell's cost that may hold a better way.
struct Open {
  Cost bound;
  std::size_t lo, hi;  // into the values

  friend bool operator<(const Open& a, const Open& b) {
    return std::tie(a.bound, a.lo) > std::tie(b.bound, b.lo);  // for a heap with the least bound on top
  }
};

class Planning {
 public:
  Planning(const Chase& chase, const PlanLimits& limits) : limits_(limits), forward_(work_) {
    work_.chase = &chase;
    work_.best.cost = kNoCost;
    work_.better = limits.better;
    if (limits.stopped || limits.seconds > 0) work_.stopped = [this] { return is_stopped(); };
  }

  Plan run(bool only_first) {
    Plan plan;
    try {
      if (!prepare()) {
        plan.reason = reason_of_failure(*work_.chase);
        return plan;
      }
      if (!only_first) search();
      bound_ = only_first ? 0 : work_.best.cost;
    } catch (const SearchStopped& stop) {
      plan.reason = stop.reason;
    }
    if (work_.best.cost < kNoCost) {
      const std::string reason = plan.reason;
      plan = std::move(work_.best);
      plan.reason = reason;
      plan.bound = std::min(bound_, plan.cost);
      plan.optimal = plan.bound == plan.cost;
    } else {
      plan.status = PlanStatus::stopped;
    }
    return plan;
  }

  const PlanEffort& effort() const { return work_.effort; }

 private:
  bool is_stopped() const {
    if (limits_.stopped && limits_.stopped()) return true;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin_;
    return limits_.seconds > 0 && taken.count() >= limits_.seconds;
  }

  // Keeps the meetings that can be reached at all.
  bool prepare() {
    const Chase& chase = *work_.chase;
    const ChaseMap& map = *chase.map;
    std::vector<Meeting> meetings = to_come(chase);
    if (meetings.empty()) return false;
    const int last = meetings.back().second - chase.now;
    work_.bits = static_cast<int>(std::bit_width(static_cast<unsigned>(last))) + 1;
    work_.steps = neighbour_steps(map);
    std::vector<int> hops;
    std::thread beside([&] { hops = hops_to(map, chase.from, meetings, last); });
    work_.latest = latest_departures(map, meetings, chase.now, 0);
    beside.join();
    work_.is_target.assign(map.index_count(), 0);
    for (std::size_t i = 0; i < meetings.size(); ++i)
      if (hops[i] <= work_.seconds(meetings[i])) {
        meetings_.push_back(meetings[i]);
        work_.is_target[meetings[i].cell] = 1;
      }
    if (meetings_.empty()) return false;
    offer_earliest(work_, meetings);
    return true;
  }

  // A way's cheapest cell costs no more than its first.
  void collect_values() {
    const ChaseMap& map = work_.map();
    const std::uint32_t most = map.cost(work_.chase->from);
    for (std::size_t i = 0; i < map.index_count(); ++i) {
      const std::uint32_t cost = map.costs()[i];
      if (cost > most || work_.latest[i] < 0) continue;
      if (values_.empty() || values_.back() != cost) values_.push_back(cost);
      if (values_.size() == values_.capacity()) make_unique();
    }
    make_unique();
  }
  void make_unique() {
    std::sort(values_.begin(), values_.end());
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
    if (2 * values_.size() > values_.capacity()) values_.reserve(4 * values_.size() + 1024);
  }

  void search() {
    collect_values();
    std::vector<Open> open{{0, 0, values_.size() - 1}};
    while (!open.empty()) {
      std::pop_heap(open.begin(), open.end());
      const Open node = open.back();
      open.pop_back();
      if (node.bound >= work_.upper()) break;
      bound_ = node.bound;
      for (const Open& part : parts(node)) {
        open.push_back(part);
        std::push_heap(open.begin(), open.end());
      }
    }
  }

  // What is left of a range once it was searched.
  std::vector<Open> parts(const Open& node) {
    const Range range{values_[node.lo], values_[node.hi]};
    RangeBound bound = forward_.run(range, meetings_);
    std::erase_if(bound.open, [&](const Meeting& m) {
      return Cost{range.lo} * work_.seconds(m) >= std::min(work_.upper(), bound.least);
    });
    if (!bound.open.empty()) {
      forward_.release();
      const RangeBound labels = search_labels(work_, range, bound.open, limits_.most_labels);
      if (labels.least < bound.least) bound = labels;
    }
    if (bound.least >= work_.upper()) return {};
    const auto at =
        static_cast<std::size_t>(std::lower_bound(values_.begin(), values_.end(), bound.cheapest) - values_.begin());
    std::vector<Open> parts;
    if (at > node.lo) parts.push_back({bound.least, node.lo, at - 1});
    if (at > node.lo && at <= node.hi) parts.push_back({bound.least, at, node.hi});
    return parts;
  }

  const PlanLimits& limits_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Workspace work_;
  ForwardSearch forward_;
  std::vector<Meeting> meetings_;
  std::vector<std::uint32_t> values_;
  Cost bound_ = 0;
};

}  // namespace

Plan exact_plan(const Chase& chase, const PlanLimits& limits, PlanEffort* effort) {
  TAUT_EXPECTS(chase.map->is_free(chase.from));
  Planning planning(chase, limits);
  Plan plan = planning.run(false);
  if (effort) *effort = planning.effort();
  return plan;
}

Plan first_plan(const Chase& chase) {
  TAUT_EXPECTS(chase.map->is_free(chase.from));
  return Planning(chase, {}).run(true);
}

}  // namespace taut::pursuit
