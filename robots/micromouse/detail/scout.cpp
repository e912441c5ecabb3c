#include <taut/robots/micromouse/detail/scout.h>

#include <algorithm>
#include <limits>

#include <taut/robots/micromouse/detail/boards.h>
#include <taut/robots/micromouse/detail/flood_step.h>
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
  const auto look = best_look(Outlook(map(), plans.weights, belief_.open_share()), plans);
  if (goal_reached() && goal_ == ScoutGoal::score &&
      (!look || look->value * plans.gain * tuning_.foresight * kExplorationShare <= 1))
    return std::nullopt;
  return look ? look->way : std::vector<Action>{};
}

std::optional<Scout::Look> Scout::best_look(const Outlook& outlook, const Plans& plans) const {
  const std::size_t cells = static_cast<std::size_t>(task().width) * static_cast<std::size_t>(task().height);
  std::vector<int> steps(cells * 4, -1);
  std::vector<float> collected(cells * 4, 0);
  std::vector<Action> by(cells * 4);
  std::vector<std::size_t> from(cells * 4), queue;
  const auto id = [&](Cell c, Side h) { return index_of(task().width, c) * 4 + static_cast<std::size_t>(h); };
  const std::size_t root = id(pose().cell, pose().heading);
  steps[root] = 0;
  queue.push_back(root);
  std::size_t best = root;
  double best_value = -std::numeric_limits<double>::infinity();
  const auto consider = [&](std::size_t node) {
    const std::size_t cell = node / 4;
    const bool shows = outlook.at(cell, static_cast<Side>(node % 4)) > 0;
    if (!shows && (goal_reached() || !task().in_goal(cell_of(task().width, cell)))) return;
    const double seen = static_cast<double>(collected[node]);
    const double value = goal_reached()
                             ? seen / (steps[node] + tuning_.patience)
                             : tuning_.reach_look * seen - steps[node] - static_cast<double>(plans.to_goal[cell]);
    if (value > best_value) best = node, best_value = value;
  };
  const Passages& certain = map().certain();
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::size_t node = queue[head];
    const Cell c = cell_of(task().width, node / 4);
    if (node != root) consider(node);
    const auto arrive = [&](Cell to, Side h, Action a) {
      const std::size_t next = id(to, h);
      if (steps[next] >= 0 && steps[next] <= steps[node]) return;
      const float sum = static_cast<float>(tuning_.side_looks) * collected[node] + outlook.at(next / 4, h);
      if (steps[next] < 0)
        steps[next] = steps[node] + 1, queue.push_back(next);
      else if (sum <= collected[next])
        return;
      collected[next] = sum;
      from[next] = node;
      by[next] = a;
    };
    for (const int rotation : {0, -90, 90}) {
      const Side h = turned(static_cast<Side>(node % 4), rotation / 90);
      if (rotation != 0) arrive(c, h, {rotation, 0});
      for (const int sign : {1, -1}) {
        const Side side = sign > 0 ? h : opposite(h);
        Cell to = c;
        for (int i = 1; i <= kLongestMove && certain.open(to, side); ++i) {
          to = ahead(to, side);
          arrive(to, h, {rotation, sign * i});
        }
      }
    }
  }
  if (best == root) return std::nullopt;
  Look look{{}, best_value};
  for (std::size_t node = best; node != root; node = from[node]) look.way.push_back(by[node]);
  return look;
}

}  // namespace taut::micromouse::detail
