#include <taut/robots/pursuit/chase.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include <taut/geometry/text.h>
#include <taut/robots/pursuit/detail/walk.h>
#include <taut/robots/pursuit/entry_planner.h>
#include <taut/robots/pursuit/exact_planner.h>

namespace taut::pursuit {

namespace {

constexpr std::uint32_t kWeight = 3;
constexpr int kLookAhead = 2, kLookAheadGrows = 3, kMostAhead = 18;

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string fault_of_move(const ChaseMap& map, CellIndex from, CellIndex to) {
  using taut::text;
  const std::string move = "the move from " + text(map.cell(from));
  if (to >= map.index_count()) return move + " leaves the map";
  const Cell a = map.cell(from), b = map.cell(to);
  if (b.x < 1 || b.x > map.x_size() || b.y < 1 || b.y > map.y_size()) return move + " leaves the map";
  if (std::abs(a.x - b.x) > 1 || std::abs(a.y - b.y) > 1) return move + " to " + text(b) + " is no step to a neighbour";
  return map.is_free(to) ? "" : move + " to " + text(b) + " ends in an obstacle";
}

/// Whole seconds, at least one; more than `most` are as many.
int seconds_of_step(double thought, int most) {
  if (!(thought > 1)) return 1;
  return static_cast<int>(std::min(std::ceil(thought), static_cast<double>(std::max(1, most))));
}

class Game {
 public:
  Game(const ChaseMap& map, const ChaseRules& rules)
      : map_(map), rules_(rules), meetings_(meetings_of(map, rules.clock)) {
    last_ = meetings_.empty() ? 0 : meetings_.back().second;
    result_.track = {{map.start(), 0}};
  }

  ChaseResult run(const NextMove& next_move) {
    bool goes_on = true;
    while (goes_on && result_.time < last_) goes_on = step(next_move);
    if (goes_on) result_.end = ChaseEnd::escaped;
    return std::move(result_);
  }

 private:
  bool step(const NextMove& next_move) {
    const CellIndex at = result_.track.back().cell;
    const std::optional<CellIndex> next = thought_of(next_move, at);
    if (!next) return false;
    if (result_.reason = fault_of_move(map_, at, *next); !result_.reason.empty()) {
      result_.reason += ", at second " + std::to_string(result_.time);
      result_.end = ChaseEnd::illegal;
      return false;
    }
    const int seconds = rules_.free_planning ? 1 : seconds_of_step(thought_, last_ + 1 - result_.time);
    result_.time += seconds;
    result_.cost += Cost{map_.cost(at)} * seconds;
    result_.moves += *next != at;
    result_.track.push_back({*next, result_.time});
    if (!is_met(result_.track.back())) return true;
    result_.end = ChaseEnd::caught;
    return false;
  }

  std::optional<CellIndex> thought_of(const NextMove& next_move, CellIndex at) {
    const auto seconds = [&] { return rules_.seconds ? rules_.seconds() : wall_seconds(); };
    const double begin = seconds();
    const std::optional<CellIndex> next = next_move(at, result_.time);
    thought_ = seconds() - begin;
    if (result_.track.size() == 1) result_.first_thought = thought_;
    result_.longest_thought = std::max(result_.longest_thought, thought_);
    return next;
  }

  bool is_met(const ChaseStep& step) const {
    const auto found = std::lower_bound(meetings_.begin(), meetings_.end(), step.second,
                                        [](const Meeting& m, int second) { return m.second < second; });
    return found != meetings_.end() && *found == Meeting{step.cell, step.second};
  }

  const ChaseMap& map_;
  const ChaseRules& rules_;
  std::vector<Meeting> meetings_;
  int last_ = 0;
  double thought_ = 0;
  ChaseResult result_;
};

}  // namespace

ChaseResult play(const ChaseMap& map, const ChaseRules& rules, const NextMove& next_move) {
  return Game(map, rules).run(next_move);
}

std::span<const NamedPlanner> chase_planners() {
  static constexpr std::array<NamedPlanner, 4> kPlanners{{
      {"exact", "the least cost, proven; its best so far when time is up",
       [](const Chase& chase, const PlanLimits& limits, PlanEffort* effort) {
         return exact_plan(chase, limits, effort);
       }},
      {"entry", "A* to the cell of the trajectory where the target looks cheapest to meet, waiting there",
       [](const Chase& chase, const PlanLimits& limits, PlanEffort* effort) {
         return entry_plan(chase, 1, limits, effort);
       }},
      {"weighted", "entry with the heuristic three times as heavy",
       [](const Chase& chase, const PlanLimits& limits, PlanEffort* effort) {
         return entry_plan(chase, kWeight, limits, effort);
       }},
      {"first", "some way in time, the one with the most seconds to spare",
       [](const Chase& chase, const PlanLimits&, PlanEffort*) { return first_plan(chase); }},
  }};
  return kPlanners;
}

const NamedPlanner* chase_planner(std::string_view name) {
  for (const NamedPlanner& planner : chase_planners())
    if (planner.name == name) return &planner;
  return nullptr;
}

Follower::Follower(const ChaseMap& map, Clock clock, PlanFunction planner, PlanLimits limits,
                   std::function<double()> seconds)
    : chase_(chase_of(map, clock)),
      planner_(std::move(planner)),
      limits_(std::move(limits)),
      seconds_(std::move(seconds)),
      look_ahead_(seconds_ ? kLookAhead : 0) {}

std::optional<CellIndex> Follower::next(CellIndex at, int now) {
  adopt(at, now);
  if (!is_on_plan(at, now) && !catch_up(at, now)) plan_anew(at, now);
  if (plan_.status != SearchStatus::found) return std::nullopt;
  if (now < chase_.now) return at;
  plan_ahead(now);
  done_ = static_cast<std::size_t>(now - chase_.now) + 1;
  return plan_.cells[done_];
}

bool Follower::is_on_plan(CellIndex at, int now) const {
  if (plan_.status != SearchStatus::found) return false;
  const auto passed = static_cast<std::size_t>(std::max(0, now - chase_.now));
  return passed + 1 < plan_.cells.size() && plan_.cells[passed] == at;
}

// Late: the rest of the way without its waiting may still be in time.
bool Follower::catch_up(CellIndex at, int now) {
  if (plan_.status != SearchStatus::found || done_ >= plan_.cells.size() || plan_.cells[done_] != at) return false;
  const int left = chase_.now + static_cast<int>(plan_.cells.size()) - 1 - now;
  std::vector<CellIndex> way(plan_.cells.begin() + static_cast<std::ptrdiff_t>(done_), plan_.cells.end());
  way.erase(std::unique(way.begin(), way.end()), way.end());
  if (left < 1 || static_cast<std::size_t>(left) + 1 < way.size()) return false;
  chase_.from = at;
  chase_.now = now;
  plan_ = detail::plan_along(chase_, way, left);
  return true;
}

void Follower::plan_anew(CellIndex at, int now) {
  chase_.from = at;
  chase_.now = now + delay_;
  double taken = 0;
  plan_ = planned(chase_, limits_, taken);
  done_ = 0;
  if (plans_ == 1) first_ = plan_;
  if (taken > 1) delay_ = 2 * seconds_of_step(taken, chase_.meetings.back().second);
}

ChasePlan Follower::planned(const Chase& chase, const PlanLimits& limits, double& taken) {
  const double begin = seconds_ ? seconds_() : 0;
  ChasePlan plan = planner_(chase, limits, nullptr);
  taken = seconds_ ? seconds_() - begin : 0;
  ++plans_;
  return plan;
}

void Follower::plan_ahead(int now) {
  const auto there = static_cast<std::size_t>(now - chase_.now + look_ahead_);
  if (look_ahead_ == 0 || ahead_ || plan_.optimal || there + 1 >= plan_.cells.size()) return;
  Ahead ahead{chase_, {}};
  ahead.chase.from = plan_.cells[there];
  ahead.chase.now = now + look_ahead_;
  PlanLimits limits = limits_;
  limits.seconds *= look_ahead_;
  double taken = 0;
  ahead.plan = planned(ahead.chase, limits, taken);
  seconds_ahead_ += taken;
  const bool is_ready = taken <= look_ahead_;
  look_ahead_ = look_ahead_ < kMostAhead ? look_ahead_ * kLookAheadGrows : 0;
  if (is_ready && ahead.plan.status == SearchStatus::found) ahead_ = std::move(ahead);
}

void Follower::adopt(CellIndex at, int now) {
  if (!ahead_ || now < ahead_->chase.now) return;
  if (now == ahead_->chase.now && at == ahead_->chase.from && is_on_plan(at, now)) {
    const auto rest = plan_.cells.begin() + (now - chase_.now);
    Cost cost = 0;
    for (auto cell = rest; cell + 1 != plan_.cells.end(); ++cell) cost += chase_.map->cost(*cell);
    if (ahead_->plan.cost < cost || ahead_->plan.optimal) {
      chase_ = std::move(ahead_->chase);
      plan_ = std::move(ahead_->plan);
      done_ = 0;
    }
  }
  ahead_.reset();
}

}  // namespace taut::pursuit
