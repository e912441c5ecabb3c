#include <taut/robots/pursuit/exact_planner.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <tuple>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/robots/pursuit/detail/block_way.h>
#include <taut/robots/pursuit/detail/range_search.h>
#include <taut/robots/pursuit/detail/side_by_side.h>

namespace taut::pursuit {

namespace {

using namespace detail;

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
  std::vector<Cost> bounds;

  friend bool operator<(const Open& a, const Open& b) {
    return std::tie(a.bound, a.lo) > std::tie(b.bound, b.lo);  // for a heap with the least bound on top
  }
};

constexpr std::size_t kLargeMap = 2'000'000;
constexpr int kBlock = 3;
constexpr std::size_t kMostLabelsOfARange = 4'000'000;  // rather split it

enum class Depth {
  first,  // what the breadth-first searches lead to
  rough,  // the best way of one range's bounds
  exact,
};

class Planning {
 public:
  Planning(const Chase& chase, const PlanLimits& limits) : limits_(limits) {
    work_.chase = &chase;
    work_.jobs = limits.jobs;
    if (limits.stopped || limits.seconds > 0) work_.stopped = [this] { return is_stopped(); };
  }

  ChasePlan run(Depth depth) {
    ChasePlan plan;
    try {
      if (depth == Depth::exact) look_at_blocks();
      if (!prepare()) {
        plan.reason = reason_of_failure(*work_.chase);
        return plan;
      }
      if (depth != Depth::first) search(depth);
    } catch (const SearchStopped& stop) {
      plan.reason = stop.reason;
      if (only_open_) bound_ = std::max({bound_, here_.bound_so_far(), beside_.bound_so_far()});
    }
    for (const RangeSearch* side : {&here_, &beside_}) take(side->worker.best);
    if (best_.cost >= kNoCost) {
      plan.status = SearchStatus::stopped;
      return plan;
    }
    const std::string reason = plan.reason;
    plan = plan_along(*work_.chase, best_.way, best_.seconds);
    plan.bound = std::min(bound_, plan.cost);
    plan.optimal = plan.bound == plan.cost;
    if (!plan.optimal) plan.reason = reason.empty() ? "too many labels" : reason;
    return plan;
  }

  PlanEffort effort() const {
    PlanEffort sum;
    for (const RangeSearch* side : {&here_, &beside_}) {
      sum.searches += side->worker.effort.searches;
      sum.expanded += side->worker.effort.expanded;
      sum.labels += side->worker.effort.labels;
    }
    return sum;
  }

 private:
  bool is_stopped() const {
    if (limits_.stopped && limits_.stopped()) return true;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin_;
    return limits_.seconds > 0 && taken.count() >= limits_.seconds;
  }

  void take(const Incumbent& incumbent) {
    if (incumbent.cost >= best_.cost) return;
    best_ = incumbent;
    tell();
  }

  void tell() const {
    if (!limits_.better || best_.cost >= kNoCost) return;
    ChasePlan plan = plan_along(*work_.chase, best_.way, best_.seconds);
    plan.bound = std::min(bound_, plan.cost);
    limits_.better(plan);
  }

  // Both sides go on with the best of both.
  void share() {
    take(here_.worker.best);
    take(beside_.worker.best);
    here_.worker.best = beside_.worker.best = best_;
  }

  // On a large map even the first searches take long.
  void look_at_blocks() {
    if (work_.map().index_count() < kLargeMap) return;
    const auto way = way_over_blocks(*work_.chase, kBlock);
    if (!way) return;
    here_.worker.offer(way->cells, way->seconds);
    share();
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
    const Watch watch = [this] {  // a first plan may come later
      if (best_.cost < kNoCost && work_.stopped && work_.stopped()) throw SearchStopped{"out of time"};
    };
    side_by_side(
        work_, [&] { work_.latest = latest_departures(map, meetings, chase.now, 0, watch); },
        [&] { work_.hops = hops_from(map, chase.from, last, watch); });
    work_.is_target.assign(map.index_count(), 0);
    for (const Meeting& m : meetings)
      if (work_.hops[m.cell] <= work_.seconds(m)) {
        meetings_.push_back(m);
        work_.is_target[m.cell] = 1;
      }
    if (meetings_.empty()) return false;
    here_.worker.offer_earliest(meetings);
    share();
    return true;
  }

  // A way's cheapest cell costs no more than its first. Leaves cells that nobody passes who is in time.
  void survey() {
    const ChaseMap& map = work_.map();
    const std::uint32_t most = map.cost(work_.chase->from);
    std::uint32_t dearest = 0;
    for (std::size_t i = 0; i < map.index_count(); ++i) {
      if (work_.latest[i] < work_.hops[i]) work_.latest[i] = -1;
      if (work_.latest[i] < 0) continue;
      const std::uint32_t cost = map.costs()[i];
      dearest = std::max(dearest, cost);
      if (cost > most) continue;
      if (values_.empty() || values_.back() != cost) values_.push_back(cost);
      if (values_.size() == values_.capacity()) make_unique();
    }
    make_unique();
    work_.choose_parts(dearest);
  }
  void make_unique() {
    std::sort(values_.begin(), values_.end());
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
    if (2 * values_.size() > values_.capacity()) values_.reserve(4 * values_.size() + 1024);
  }

  void search(Depth depth) {
    survey();
    open_.push_back({0, 0, values_.size() - 1, std::vector<Cost>(meetings_.size(), 0)});
    if (depth == Depth::rough) return look_roughly();
    bound_ = work_.seconds(meetings_.front()) * Cost{values_.front()};
    Cost stuck = kNoCost;
    while (!open_.empty() && open_.front().bound < best_.cost) {
      const Cost bound = std::min(stuck, open_.front().bound);
      if (std::exchange(bound_, bound) < bound) tell();
      std::vector<Open> nodes;
      while (nodes.size() < 2 && !open_.empty() && open_.front().bound < best_.cost) {
        std::pop_heap(open_.begin(), open_.end());
        nodes.push_back(std::move(open_.back()));
        open_.pop_back();
      }
      only_open_ = nodes.size() == 1 && open_.empty() && stuck >= kNoCost;
      const std::vector<RangeSearch::Answer> answers =
          nodes.size() == 2 ? both(nodes) : std::vector{one(nodes[0], most_labels(nodes[0]))};
      share();
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!split(nodes[i], answers[i])) stuck = std::min(stuck, answers[i].bound);
    }
    bound_ = std::min(stuck, best_.cost);
  }

  void look_roughly() {
    one(open_.front(), 0);
    share();
  }

  CostRange range_of(const Open& node) const { return {values_[node.lo], values_[node.hi]}; }

  std::size_t most_labels(const Open& node) const {
    return std::min(limits_.most_labels / 2, node.lo == node.hi ? limits_.most_labels : kMostLabelsOfARange);
  }

  static RangeSearch::Answer evaluated(RangeSearch& search, const CostRange& range, Open& node,
                                       std::size_t most_labels) {
    search.begin(range, std::move(node.bounds));
    search.pass(search.worker.work.parts * range.lo);
    return search.finish(most_labels);
  }

  std::vector<RangeSearch::Answer> both(std::vector<Open>& nodes) {
    std::vector<RangeSearch::Answer> answers(2);
    side_by_side(
        work_, [&] { answers[0] = evaluated(here_, range_of(nodes[0]), nodes[0], most_labels(nodes[0])); },
        [&] { answers[1] = evaluated(beside_, range_of(nodes[1]), nodes[1], most_labels(nodes[1])); });
    return answers;
  }

  RangeSearch::Answer one(Open& node, std::size_t most_labels) {
    const CostRange range = range_of(node);
    here_.begin(range, node.bounds);
    beside_.begin(range, std::move(node.bounds));
    side_by_side(
        work_, [&] { here_.pass(work_.parts * range.lo); }, [&] { beside_.pass(beside_.guess()); });
    here_.absorb(beside_);
    beside_.release();
    return here_.finish(most_labels);
  }

  // False when what is left of a node cannot be split.
  bool split(const Open& node, const RangeSearch::Answer& answer) {
    if (answer.bound >= best_.cost) return true;
    if (answer.is_open && node.lo == node.hi) return false;
    const CostRange range = range_of(node);
    const std::uint32_t middle = range.lo + (range.hi - range.lo) / 2 + 1;
    const std::uint32_t value = answer.is_open ? middle : std::min(middle, answer.cheapest);
    const auto at = std::max(
        static_cast<std::size_t>(std::lower_bound(values_.begin(), values_.end(), value) - values_.begin()), node.lo);
    if (at == node.lo) return true;  // the bound's way costs no more than the bound
    for (const auto& [lo, hi] : {std::pair{node.lo, at - 1}, std::pair{at, node.hi}}) {
      if (lo > hi) continue;
      open_.push_back({answer.bound, lo, hi, answer.bounds});
      std::push_heap(open_.begin(), open_.end());
    }
    return true;
  }

  const PlanLimits& limits_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Workspace work_;
  std::vector<Meeting> meetings_;
  RangeSearch here_{work_, meetings_}, beside_{work_, meetings_};
  std::vector<std::uint32_t> values_;
  std::vector<Open> open_;
  Incumbent best_;
  bool only_open_ = false;  // the two sides look at all there is
  Cost bound_ = 0;
};

}  // namespace

ChasePlan exact_plan(const Chase& chase, const PlanLimits& limits, PlanEffort* effort) {
  TAUT_EXPECTS(chase.map->is_free(chase.from));
  Planning planning(chase, limits);
  ChasePlan plan = planning.run(Depth::exact);
  if (effort) *effort = planning.effort();
  return plan;
}

ChasePlan first_plan(const Chase& chase) {
  TAUT_EXPECTS(chase.map->is_free(chase.from));
  return Planning(chase, {}).run(Depth::first);
}

ChasePlan rough_plan(const Chase& chase) {
  TAUT_EXPECTS(chase.map->is_free(chase.from));
  return Planning(chase, {}).run(Depth::rough);
}

}  // namespace taut::pursuit
