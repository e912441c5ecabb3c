#include <taut/robots/pursuit/entry_planner.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_map>

#include <taut/geometry/expects.h>
#include <taut/robots/pursuit/detail/hops.h>
#include <taut/robots/pursuit/detail/radix_heap.h>
#include <taut/robots/pursuit/exact_planner.h>

namespace taut::pursuit {

namespace {

using detail::RadixHeap;

constexpr std::uint64_t kFar = ~std::uint64_t{0};

struct OutOfTime {};

/// What the searches of one plan share.
struct Ground {
  const Chase& chase;
  const PlanLimits& limits;
  int last = 0;  // seconds until the last meeting
  int bits = 0;  // of a key, for the number of moves
  std::vector<std::ptrdiff_t> steps{};
  PlanEffort effort{};
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();

  const ChaseMap& map() const { return *chase.map; }
  std::uint64_t key(Cost cost, int moves) const {
    return (static_cast<std::uint64_t>(cost) << bits) + static_cast<std::uint64_t>(moves);
  }
  Cost cost(std::uint64_t key) const { return static_cast<Cost>(key >> bits); }
  int moves(std::uint64_t key) const { return static_cast<int>(key & ((std::uint64_t{1} << bits) - 1)); }
  CellIndex neighbour(CellIndex c, std::ptrdiff_t step) const {
    return static_cast<CellIndex>(static_cast<std::ptrdiff_t>(c) + step);
  }
  void count() {
    if (++effort.expanded % 4096 != 0) return;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    if ((limits.seconds > 0 && taken.count() >= limits.seconds) || (limits.stopped && limits.stopped()))
      throw OutOfTime{};
  }
};

/// Keys (cost, moves) of ways of at most `last` moves between `origin` and every cell; a move costs what the cell that
/// is left costs, which is the nearer one to the origin when the ways lead away from it.
std::vector<std::uint64_t> keys_from(Ground& ground, CellIndex origin, bool away) {
  const ChaseMap& map = ground.map();
  std::vector<std::uint64_t> keys(map.index_count(), kFar);
  RadixHeap<CellIndex> queue;
  keys[origin] = 0;
  queue.push(0, origin);
  ++ground.effort.searches;
  while (!queue.empty()) {
    const auto [key, cell] = queue.pop();
    if (keys[cell] != key) continue;
    ground.count();
    if (ground.moves(key) == ground.last) continue;
    for (const std::ptrdiff_t step : ground.steps) {
      const CellIndex next = ground.neighbour(cell, step);
      if (!map.is_free(next)) continue;
      const std::uint64_t longer = key + ground.key(map.cost(away ? cell : next), 1);
      if (longer >= keys[next]) continue;
      keys[next] = longer;
      queue.push(longer, next);
    }
  }
  return keys;
}

std::vector<CellIndex> trace(const Ground& ground, const std::vector<std::uint64_t>& keys, CellIndex to) {
  std::vector<CellIndex> way{to};
  while (way.back() != ground.chase.from)
    for (const std::ptrdiff_t step : ground.steps) {
      const CellIndex before = ground.neighbour(way.back(), step);
      if (keys[before] == kFar) continue;
      if (keys[before] + ground.key(ground.map().cost(before), 1) != keys[way.back()]) continue;
      way.push_back(before);
      break;
    }
  std::reverse(way.begin(), way.end());
  return way;
}

std::optional<Meeting> cheapest_entry(const Ground& ground, const std::vector<std::uint64_t>& keys) {
  std::optional<Meeting> goal;
  Cost least = 0;
  for (const Meeting& m : ground.chase.meetings) {
    const int seconds = m.second - ground.chase.now;
    if (seconds < 1 || keys[m.cell] == kFar || ground.moves(keys[m.cell]) > seconds) continue;
    const Cost waiting = Cost{ground.map().cost(m.cell)} * (seconds - ground.moves(keys[m.cell]));
    const Cost cost = ground.cost(keys[m.cell]) + waiting;
    if (goal && cost >= least) continue;
    goal = m;
    least = cost;
  }
  return goal;
}

struct State {
  CellIndex cell = 0;
  int second = 0;
};

std::uint64_t code(State s) { return (std::uint64_t{s.cell} << 32) | static_cast<std::uint32_t>(s.second); }

/// A* over (cell, second).
class EntrySearch {
 public:
  EntrySearch(Ground& ground, const Meeting& goal, std::uint32_t weight)
      : ground_(ground),
        goal_(goal),
        seconds_(goal.second - ground.chase.now),
        weight_(weight),
        heuristic_(keys_from(ground, goal.cell, false)) {}

  /// Empty when there are too many states.
  std::vector<CellIndex> run() {
    reach({ground_.chase.from, 0}, 0, {ground_.chase.from, 0});
    while (!queue_.empty()) {
      const State state = queue_.top().state;
      queue_.pop();
      Seen& seen = seen_.find(code(state))->second;
      if (seen.closed) continue;
      seen.closed = true;
      ground_.count();
      if (state.cell == goal_.cell) return way_to(state);
      if (!expand(state, seen.cost)) return {};
    }
    return {};
  }

 private:
  struct Seen {
    Cost cost = 0;
    CellIndex before = 0;
    bool closed = false;
  };

  // A heavy heuristic is not consistent: f may fall. Of equal ones first what is nearer to the goal.
  struct Item {
    std::uint64_t f = 0;
    std::uint64_t rest = 0;
    State state;

    friend bool operator<(const Item& a, const Item& b) {
      return std::make_tuple(b.f, b.rest, code(b.state)) < std::make_tuple(a.f, a.rest, code(a.state));
    }
  };

  bool expand(State state, Cost cost) {
    const Cost after = cost + ground_.map().cost(state.cell);
    if (state.second == seconds_) return true;
    for (const std::ptrdiff_t step : ground_.steps)
      reach({ground_.neighbour(state.cell, step), state.second + 1}, after, state);
    reach({state.cell, state.second + 1}, after, state);
    ground_.effort.labels = seen_.size();
    return seen_.size() <= ground_.limits.most_labels;
  }

  void reach(State state, Cost cost, State before) {
    if (heuristic_[state.cell] == kFar || least_moves(state.cell) > seconds_ - state.second) return;
    const auto [at, is_new] = seen_.try_emplace(code(state), Seen{cost, before.cell, false});
    if (!is_new) {
      if (at->second.closed || at->second.cost <= cost) return;
      at->second = {cost, before.cell, false};
    }
    const std::uint64_t rest = heuristic_[state.cell] >> ground_.bits;
    queue_.push({static_cast<std::uint64_t>(cost) + weight_ * rest, rest, state});
  }

  int least_moves(CellIndex cell) const {
    const Cell a = ground_.map().cell(cell), b = ground_.map().cell(goal_.cell);
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
  }

  std::vector<CellIndex> way_to(State state) const {
    std::vector<CellIndex> way{state.cell};
    for (; state.second > 0; --state.second) {
      state.cell = seen_.find(code(state))->second.before;
      way.push_back(state.cell);
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  Ground& ground_;
  Meeting goal_;
  int seconds_;
  std::uint64_t weight_;
  std::vector<std::uint64_t> heuristic_;
  std::unordered_map<std::uint64_t, Seen> seen_;
  std::priority_queue<Item> queue_;
};

/// Along `way`, which may hold waiting, then waiting at its end until `goal`.
ChasePlan plan_to(const Chase& chase, std::vector<CellIndex> way, const Meeting& goal) {
  way.resize(static_cast<std::size_t>(goal.second - chase.now) + 1, goal.cell);
  ChasePlan plan{SearchStatus::found, false, 0, std::move(way), 0, {}};
  for (const Meeting& m : chase.meetings) {
    const int seconds = m.second - chase.now;
    if (seconds < 1 || plan.cells[static_cast<std::size_t>(seconds)] != m.cell) continue;
    plan.cells.resize(static_cast<std::size_t>(seconds) + 1);
    break;
  }
  for (std::size_t i = 0; i + 1 < plan.cells.size(); ++i) plan.cost += chase.map->cost(plan.cells[i]);
  return plan;
}

ChasePlan without_entry(const Chase& chase) {
  ChasePlan plan = first_plan(chase);
  if (plan.status != SearchStatus::found) return plan;
  plan = {};
  plan.status = SearchStatus::stopped;
  plan.reason = "no way of least cost reaches the target in time, though others do";
  return plan;
}

ChasePlan planned(Ground& ground, std::uint32_t weight) {
  std::vector<std::uint64_t> keys = keys_from(ground, ground.chase.from, true);
  const std::optional<Meeting> goal = cheapest_entry(ground, keys);
  if (!goal) return without_entry(ground.chase);
  std::vector<CellIndex> way = EntrySearch(ground, *goal, weight).run();
  if (way.empty()) way = trace(ground, keys, goal->cell);
  return plan_to(ground.chase, std::move(way), *goal);
}

}  // namespace

ChasePlan entry_plan(const Chase& chase, std::uint32_t weight, const PlanLimits& limits, PlanEffort* effort) {
  TAUT_EXPECTS(chase.map->is_free(chase.from));
  TAUT_EXPECTS(weight >= 1 && weight <= 1000);
  Ground ground{chase, limits};
  if (!chase.meetings.empty()) ground.last = std::max(0, chase.meetings.back().second - chase.now);
  ground.bits = static_cast<int>(std::bit_width(static_cast<unsigned>(ground.last)));
  ground.steps = detail::neighbour_steps(*chase.map);
  ChasePlan plan;
  try {
    plan = planned(ground, weight);
  } catch (const OutOfTime&) {
    plan = {};
    plan.status = SearchStatus::stopped;
    plan.reason = "out of time";
  }
  if (effort) *effort = ground.effort;
  return plan;
}

}  // namespace taut::pursuit
