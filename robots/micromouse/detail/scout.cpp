#include <taut/robots/micromouse/detail/scout.h>

#include <algorithm>
#include <limits>

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

  void into(WallWeights& weights) { weights_ = &weights; }

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
  WallWeights* weights_ = nullptr;
};

/// Fewer samples where each costs more: from 16 x 16 cells on, as many cells in all.
int samples_for(const Task& task, const ScoutTuning& tuning) {
  constexpr int kCells = 256, kFewest = 8;
  return std::max(kFewest, tuning.samples * kCells / std::max(kCells, task.width * task.height));
}

}  // namespace

Scout::Scout(const Task& task, ScoutGoal goal, const ScoutTuning& tuning)
    : MappingRobot(task), goal_(goal), tuning_(tuning), belief_(task, samples_for(task, tuning), 20240229) {}

Scout::Plans Scout::sample_plans(std::optional<int> hi, double density) {
  Plans plans;
  const std::size_t cells = static_cast<std::size_t>(task().width) * static_cast<std::size_t>(task().height);
  plans.weights = {std::vector<float>(cells), std::vector<float>(cells)};
  const int limit = hi.value_or(std::numeric_limits<int>::max());
  PlanTracer tracer(task(), map());
  tracer.into(plans.weights);
  Passages world;
  int shorter = 0;
  // Walls are not independent (mazes are connected, routes long): samples range from thin ones to the density believed in.
  const auto thinned = [&](int k) { return density * (tuning_.thin + (1 - tuning_.thin) * (k % 4) / 3.0); };
  for (int k = 0; k < belief_.samples(); ++k) {
    belief_.world(k, map(), thinned(k), world);
    const int steps = tracer.trace(world, limit, hi ? tuning_.gain_weight : 0);
    if (steps > 0 && steps < limit) {
      ++shorter;
      if (hi) plans.gain += *hi - steps;
    }
  }
  plans.gain /= belief_.samples();
  // Few plans found: look also at worlds with fewer walls, down to the optimistic one, so that no plan is forgotten.
  for (double d = density / 2; shorter * 2 < belief_.samples(); d = d < 0.04 ? 0 : d / 2) {
    for (int k = 0; k < belief_.samples() && shorter * 2 < belief_.samples(); ++k) {
      belief_.world(k, map(), d, world);
      const int steps = tracer.trace(world, limit, hi ? tuning_.gain_weight : 0);
      shorter += steps > 0 && steps < limit;
    }
    if (d == 0) break;
  }
  for (std::size_t i = 0; i < cells; ++i)
    plans.total += static_cast<double>(plans.weights.north[i] + plans.weights.east[i]);
  if (!hi || !goal_reached()) {
    plans.to_goal.assign(cells, 0);
    const auto far = static_cast<float>(cells);
    for (int k = 0; k < belief_.samples(); ++k) {
      belief_.world(k, map(), thinned(k), world);
      const StepField field(world, task().goal);
      for (std::size_t i = 0; i < cells; ++i) {
        const int steps = field(cell_of(task().width, i));
        plans.to_goal[i] += steps < 0 ? std::min(far, 60.F) : static_cast<float>(steps);
      }
    }
    for (float& f : plans.to_goal) f /= static_cast<float>(belief_.samples());
  }
  return plans;
}

Action Scout::explore() {
  const auto lo = optimum(map().possible(), task()), hi = optimum(map().certain(), task());
  if (!lo) return {};
  if (goal_reached() && (lo == hi || steps_left() <= *hi + 2)) return kReset;
  const double density = Belief::density(map(), tuning_.prior_share, tuning_.prior_weight);
  Plans plans = sample_plans(hi, density);
  if (plans.total > 0) {
    const auto scale = static_cast<float>(1 / plans.total);
    for (float& f : plans.weights.north) f *= scale;
    for (float& f : plans.weights.east) f *= scale;
  }
  if (goal_reached() && goal_ == ScoutGoal::score &&
      plans.gain * tuning_.stop_factor <= tuning_.stop_steps / kExplorationShare)
    return kReset;
  const Outlook outlook(map(), plans.weights, density);
  const auto action = best_look(outlook, goal_reached() ? nullptr : &plans.to_goal);
  return action.value_or(Action{90, 0});
}

std::optional<Action> Scout::best_look(const Outlook& outlook, const std::vector<float>* to_goal) {
  struct Node {
    std::size_t cell;
    Side heading;
    Action first;
    int steps;
  };
  const std::size_t cells = static_cast<std::size_t>(task().width) * static_cast<std::size_t>(task().height);
  std::vector<std::int16_t> steps(cells * 4, -1);
  std::vector<float> collected(cells * 4, 0);
  std::vector<Action> first(cells * 4);
  std::vector<std::size_t> queue;
  const auto id = [&](Cell c, Side h) { return index_of(task().width, c) * 4 + static_cast<std::size_t>(h); };
  const std::size_t root = id(pose().cell, pose().heading);
  steps[root] = 0;
  queue.push_back(root);
  float best = -std::numeric_limits<float>::infinity();
  std::optional<Action> action;
  const Passages& certain = map().certain();
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::size_t node = queue[head];
    const Cell c = cell_of(task().width, node / 4);
    const Side heading = static_cast<Side>(node % 4);
    if (node != root) {
      float look = outlook.at(node / 4, heading);
      float value;
      const auto n = static_cast<float>(steps[node]);
      if (to_goal != nullptr) {
        const float left = (*to_goal)[node / 4];
        const bool ends = task().in_goal(c);
        value = look > 0 || ends ? -(n + left) + static_cast<float>(tuning_.reach_look) * collected[node] * 10
                                 : -std::numeric_limits<float>::infinity();
      } else {
        value = look > 0 ? collected[node] / (n + static_cast<float>(tuning_.patience)) : -1.F;
        if (look <= 0) value = -std::numeric_limits<float>::infinity();
      }
      if (value > best) best = value, action = first[node];
    }
    const auto arrive = [&](Cell to, Side h, Action a) {
      const std::size_t next = id(to, h);
      if (steps[next] >= 0 && steps[next] <= steps[node]) return;
      const float sum = static_cast<float>(tuning_.side_looks) * collected[node] + outlook.at(next / 4, h);
      if (steps[next] < 0) {
        steps[next] = static_cast<std::int16_t>(steps[node] + 1);
        queue.push_back(next);
      } else if (sum <= collected[next]) {
        return;
      }
      collected[next] = sum;
      first[next] = node == root ? a : first[node];
    };
    for (const int rotation : {0, -90, 90}) {
      const Side h = turned(heading, rotation / 90);
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
  return action;
}

}  // namespace taut::micromouse::detail
