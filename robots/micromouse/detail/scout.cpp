#include <taut/robots/micromouse/detail/scout.h>

#include <algorithm>
#include <limits>

#include <taut/robots/micromouse/detail/boards.h>
#include <taut/robots/micromouse/detail/flood_step.h>
#include <taut/robots/micromouse/detail/look_tour.h>
#include <taut/robots/micromouse/detail/look_ways.h>
#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse::detail {

namespace {

/// Adds weight to each unknown wall that one shortest route of the sampled maze passes.
class PlanTracer {
 public:
  PlanTracer(const Task& task, const WallMap& map) : task_(task), map_(map) {}

  /// Returns the number of steps of the sampled maze, or 0 when it has no route.
  int trace(const Passages& world, int limit, double scale) {
    const StepField to_goal(world, task_.goal);
    const int steps = to_goal(task_.start);
    if (steps <= 0 || steps >= limit) return std::max(steps, 0);
    std::vector<std::pair<std::vector<float>*, std::size_t>> needed;
    Cell at = task_.start;
    while (to_goal(at) > 0) at = advance(world, to_goal, at, needed);
    const double each = (1 + scale * (limit - steps)) / static_cast<double>(std::max<std::size_t>(needed.size(), 1));
    for (auto& [board, i] : needed) (*board)[i] += static_cast<float>(each);
    return steps;
  }

  void into(WallBoard& weights) { weights_ = &weights; }

 private:
  // Of the next stops of shortest routes, the one behind the fewest unknown walls.
  Cell advance(const Passages& world, const StepField& to_goal, Cell at,
               std::vector<std::pair<std::vector<float>*, std::size_t>>& needed) {
    Cell best = at;
    int least = std::numeric_limits<int>::max();
    for (const Side side : kSides) {
      int unknown = 0;
      Cell c = at;
      for (int i = 0; i < kLongestMove && world.open(c, side); ++i) {
        unknown += map_.state(c, side) == WallState::unknown;
        c = ahead(c, side);
        if (to_goal(c) == to_goal(at) - 1 && unknown < least) best = c, least = unknown;
      }
    }
    const Side side = side_towards(at, best);
    for (Cell c = at; c != best; c = ahead(c, side)) {
      if (map_.state(c, side) != WallState::unknown) continue;
      const CellSide wall = canonical({c, side});
      auto& board = wall.side == Side::north ? weights_->north : weights_->east;
      needed.emplace_back(&board, index_of(task_.width, wall.cell));
    }
    return best;
  }

  const Task& task_;
  const WallMap& map_;
  WallBoard* weights_ = nullptr;
};

/// Fewer samples where each costs more.
int samples_for(const Task& task, const ScoutTuning& tuning) {
  constexpr int kCellsInAll = 36'864, kFewest = 8;
  return std::clamp(kCellsInAll / (task.width * task.height), std::min(kFewest, tuning.samples), tuning.samples);
}

}  // namespace

Scout::Scout(const Task& task, ScoutGoal goal, std::uint64_t seed, const ScoutTuning& tuning)
    : MappingRobot(task), goal_(goal), tuning_(tuning), belief_(task, samples_for(task, tuning), 20240228 + seed) {}

Scout::Plans Scout::sample_plans(std::optional<int> hi) {
  Plans plans;
  const std::size_t cells = static_cast<std::size_t>(task().width) * static_cast<std::size_t>(task().height);
  plans.weights = {std::vector<float>(cells), std::vector<float>(cells)};
  const int limit = hi.value_or(std::numeric_limits<int>::max());
  const double scale = hi ? tuning_.gain_weight : 0;
  PlanTracer tracer(task(), map());
  tracer.into(plans.weights);
  int shorter = 0;
  for (int k = 0; k < belief_.samples(); ++k) {
    const int steps = tracer.trace(belief_.world(k), limit, scale);
    if (steps <= 0 || steps >= limit) continue;
    ++shorter;
    if (hi) plans.gain += *hi - steps;
  }
  plans.gain /= belief_.samples();
  // A proof has to end unlikely plans too: where few are left, look also at worlds with fewer walls, down to the
  // optimistic one.
  Passages world;
  for (const double share : {0.375, 0.75, 1.0})
    for (int k = 0; k < belief_.samples() && goal_ == ScoutGoal::proof && shorter * 2 < belief_.samples(); ++k) {
      belief_.thinned(k, share, world);
      const int steps = tracer.trace(world, limit, scale);
      shorter += steps > 0 && steps < limit;
    }
  double total = 0;
  for (std::size_t i = 0; i < cells; ++i) total += static_cast<double>(plans.weights.north[i] + plans.weights.east[i]);
  for (auto* board : {&plans.weights.north, &plans.weights.east})
    for (float& f : *board) f = total > 0 ? static_cast<float>(f / total) : 0;
  if (!goal_reached()) plans.to_goal = steps_to_goal();
  return plans;
}

bool Scout::hurried() const {
  const int steps = static_cast<int>(tuning_.leisure * (task().width + task().height));
  return steps_taken() >= std::min(steps, task().max_steps / 5);
}

std::vector<float> Scout::steps_to_goal() const {
  const std::size_t cells = static_cast<std::size_t>(task().width) * static_cast<std::size_t>(task().height);
  std::vector<float> mean(cells);
  for (int k = 0; k < belief_.samples(); ++k) {
    const StepField field(belief_.world(k), task().goal);
    for (std::size_t i = 0; i < cells; ++i) {
      const Cell c = cell_of(task().width, i);
      mean[i] += static_cast<float>(field.reached(c) ? field(c) : static_cast<int>(cells));
    }
  }
  for (float& f : mean) f /= static_cast<float>(belief_.samples());
  return mean;
}

Action Scout::explore() {
  // Decided anew each step; but when nothing new has come for long, a way is followed to its end, so that no two looks
  // swing it.
  constexpr int kLong = 6;
  idle_ = learned() ? 0 : idle_ + 1;
  const auto hi = optimum(map().certain(), task());
  if (goal_reached() && steps_left() <= *hi + 2) return kReset;
  if (!goal_reached() && hurried()) return flood_step(map(), task(), pose());
  if (idle_ <= kLong || way_.empty()) {
    const auto way = decide();
    if (!way) return kReset;
    way_ = *way;
  }
  if (way_.empty()) return {90, 0};
  const Action next = way_.back();
  way_.pop_back();
  return next;
}

std::optional<std::vector<Action>> Scout::decide() {
  const auto lo = optimum(map().possible(), task()), hi = optimum(map().certain(), task());
  if (!lo) return std::vector<Action>{};
  if (goal_reached() && lo == hi) return std::nullopt;
  belief_.update(map());
  const Plans plans = sample_plans(hi);
  const auto look = next_look(plans);
  if (goal_reached() && goal_ == ScoutGoal::score &&
      (!look || look->value * plans.gain * tuning_.foresight * kExplorationShare <= 1))
    return std::nullopt;
  return look ? look->way : std::vector<Action>{};
}

std::optional<Scout::Look> Scout::next_look(const Plans& plans) const {
  const WallBoard open = belief_.open_share();
  const bool single = !goal_reached() || goal_ == ScoutGoal::score || tuning_.tour == 0;
  if (single) return best_look(Outlook(map(), plans.weights, open), plans);
  const TourTuning tuning{.looks = tuning_.tour, .side_looks = tuning_.side_looks};
  auto tour = best_tour(map(), pose(), plans.weights, open, tuning);
  return tour ? std::optional(Look{std::move(tour->way), tour->value}) : std::nullopt;
}

std::optional<Scout::Look> Scout::best_look(const Outlook& outlook, const Plans& plans) const {
  const std::size_t root = node_of(map(), pose());
  const LookWays ways = look_ways(map(), root, outlook, tuning_.side_looks);
  std::size_t best = root;
  double best_value = -std::numeric_limits<double>::infinity();
  for (const std::size_t node : ways.order) {
    if (node == root) continue;
    const std::size_t cell = node / 4;
    const bool shows = outlook.at(cell, static_cast<Side>(node % 4)) > 0;
    if (!shows && (goal_reached() || !task().in_goal(cell_of(task().width, cell)))) continue;
    const double seen = static_cast<double>(ways.collected[node]);
    const int steps = ways.steps[node];
    const double value = goal_reached() ? seen / (steps + tuning_.patience)
                                        : tuning_.reach_look * seen - steps - static_cast<double>(plans.to_goal[cell]);
    if (value > best_value) best = node, best_value = value;
  }
  if (best == root) return std::nullopt;
  return Look{ways.way_to(best), best_value};
}

}  // namespace taut::micromouse::detail
