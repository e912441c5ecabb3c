#include <taut/robots/micromouse/explorers.h>

#include <algorithm>
#include <array>
#include <queue>

#include <taut/geometry/draws.h>
#include <taut/robots/micromouse/detail/flood_step.h>
#include <taut/robots/micromouse/detail/scout.h>
#include <taut/robots/micromouse/mapping_robot.h>
#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse {

namespace {

class RandomWalker final : public MappingRobot {
 public:
  RandomWalker(const Task& task, std::uint64_t seed) : MappingRobot(task), draws_(seed) {}

 private:
  Action explore() override {
    if (goal_reached()) return kReset;
    const auto next = one_step_from(map().certain(), pose().cell);
    if (next.empty()) return {};
    return action_towards(pose(), next[draws_.below(static_cast<std::uint32_t>(next.size()))]);
  }

  taut::Draws draws_;
};

class WallFollower final : public MappingRobot {
 public:
  using MappingRobot::MappingRobot;

 private:
  Action explore() override {
    if (goal_reached()) return kReset;
    for (const int quarters : {-1, 0, 1})
      if (map().certain().open(pose().cell, turned(pose().heading, quarters))) return {90 * quarters, 1};
    return {90, 0};  // a dead end: turn on the spot, twice
  }
};

/// Keeps which cells it has stood in.
class Visitor : public MappingRobot {
 public:
  explicit Visitor(const Task& task)
      : MappingRobot(task), visited_(static_cast<std::size_t>(task.width) * static_cast<std::size_t>(task.height)) {}

 protected:
  bool visited(Cell c) const { return visited_[id(c)]; }
  void visit(Cell c) { visited_[id(c)] = true; }

 private:
  std::size_t id(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(task().width) + static_cast<std::size_t>(c.x);
  }
  std::vector<bool> visited_;
};

class DepthFirst final : public Visitor {
 public:
  using Visitor::Visitor;

 private:
  Action explore() override {
    if (goal_reached()) return kReset;
    const Cell here = pose().cell;
    visit(here);
    if (map().state(here, opposite(pose().heading)) == WallState::unknown) return {90, 0};
    const StepField to_goal(passages(task().width, task().height, true), task().goal);
    Cell best = here;
    for (const Side side : kSides) {
      const Cell c = ahead(here, side);
      if (!map().certain().open(here, side) || visited(c)) continue;
      if (best == here || to_goal(c) < to_goal(best)) best = c;
    }
    if (best != here) {
      trail_.push_back(here);
      return action_towards(pose(), best);
    }
    if (trail_.empty()) return {90, 0};
    const Cell back = trail_.back();
    trail_.pop_back();
    return action_towards(pose(), back);
  }

  std::vector<Cell> trail_;
};

/// The first step of a shortest way on known passages to the nearest of the cells that `wanted` accepts; ties by index.
template <class Wanted>
std::optional<Action> step_to_nearest(const MappingRobot& robot, const MousePose& pose, Wanted wanted) {
  const Passages& certain = robot.map().certain();
  const StepField from_here(certain, {pose.cell});
  std::optional<Cell> best;
  for (int y = 0; y < certain.height; ++y)
    for (int x = 0; x < certain.width; ++x)
      if (const Cell c{x, y}; from_here(c) > 0 && wanted(c) && (!best || from_here(c) < from_here(*best))) best = c;
  if (!best) return std::nullopt;
  const StepField from_there(certain, {*best});
  const auto next = one_step_from(certain, pose.cell);
  const int left = from_there(pose.cell);
  return action_towards(pose,
                        *std::find_if(next.begin(), next.end(), [&](Cell c) { return from_there(c) == left - 1; }));
}

class BreadthFirst final : public Visitor {
 public:
  using Visitor::Visitor;

 private:
  Action explore() override {
    visit(pose().cell);
    if (goal_reached()) {
      const auto known = optimum(map().certain(), task());
      if (known && steps_left() <= *known + 2) return kReset;
    }
    if (const auto step = step_to_nearest(*this, pose(), [&](Cell c) { return !visited(c); })) return *step;
    if (goal_reached()) return kReset;
    // Every visited cell was passed through or ended in; the goal counts only when ended in.
    if (const auto step = step_to_nearest(*this, pose(), [&](Cell c) { return task().in_goal(c); })) return *step;
    return {90, 0};
  }
};

class FloodFill final : public MappingRobot {
 public:
  using MappingRobot::MappingRobot;

 private:
  Action explore() override { return goal_reached() ? kReset : detail::flood_step(map(), task(), pose()); }
};

class AStar final : public MappingRobot {
 public:
  using MappingRobot::MappingRobot;

 private:
  Action explore() override {
    if (goal_reached()) return kReset;
    const std::vector<Cell> cells = path();
    if (cells.size() < 2) return {90, 0};
    // As far along the first straight as is known to be open.
    const Cell here = pose().cell;
    Cell to = here;
    for (std::size_t i = 1; i < cells.size() && i <= kLongestMove; ++i) {
      if (cells[i].x != here.x && cells[i].y != here.y) break;
      const Side side = side_towards(cells[i - 1], cells[i]);
      if (!map().certain().open(cells[i - 1], side)) break;
      to = cells[i];
    }
    return to == here ? Action{90, 0} : action_towards(pose(), to);
  }

  int estimate(Cell c) const {
    int least = task().width + task().height;
    for (const Cell g : task().goal) least = std::min(least, std::abs(g.x - c.x) + std::abs(g.y - c.y));
    return least;
  }

  // A* over cells, unknown walls open; among equal totals the one nearer to the goal, then the one found last.
  std::vector<Cell> path() const {
    const auto w = static_cast<std::size_t>(task().width), h = static_cast<std::size_t>(task().height);
    const auto id = [&](Cell c) { return static_cast<std::size_t>(c.y) * w + static_cast<std::size_t>(c.x); };
    std::vector<int> cost(w * h, -1);
    std::vector<Cell> from(w * h);
    using Entry = std::array<int, 5>;  // total, estimate, -age, x, y
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    int age = 0;
    cost[id(pose().cell)] = 0;
    open.push({estimate(pose().cell), estimate(pose().cell), 0, pose().cell.x, pose().cell.y});
    while (!open.empty()) {
      const Entry top = open.top();
      open.pop();
      const Cell c{top[3], top[4]};
      if (task().in_goal(c)) return trace(c, from, id);
      if (cost[id(c)] < top[0] - top[1]) continue;
      for (const Side side : kSides) {
        const Cell n = ahead(c, side);
        if (!map().possible().open(c, side) || (cost[id(n)] >= 0 && cost[id(n)] <= cost[id(c)] + 1)) continue;
        cost[id(n)] = cost[id(c)] + 1;
        from[id(n)] = c;
        open.push({cost[id(n)] + estimate(n), estimate(n), -++age, n.x, n.y});
      }
    }
    return {};
  }

  template <class Id>
  std::vector<Cell> trace(Cell c, const std::vector<Cell>& from, Id id) const {
    std::vector<Cell> cells{c};
    while (cells.back() != pose().cell) cells.push_back(from[id(cells.back())]);
    std::reverse(cells.begin(), cells.end());
    return cells;
  }
};

class PlainProver final : public MappingRobot {
 public:
  using MappingRobot::MappingRobot;

 private:
  Action explore() override {
    if (!goal_reached()) return detail::flood_step(map(), task(), pose());
    const auto lo = optimum(map().possible(), task()), hi = optimum(map().certain(), task());
    if (lo == hi || (hi && steps_left() <= *hi + 2)) return kReset;
    const std::vector<Cell> open = unverified();
    if (std::binary_search(open.begin(), open.end(), pose().cell)) return {90, 0};
    if (const auto step =
            step_to_nearest(*this, pose(), [&](Cell c) { return std::binary_search(open.begin(), open.end(), c); }))
      return *step;
    return {90, 0};
  }

  // Cells of the shortest optimistic route on either side of a wall not yet seen.
  std::vector<Cell> unverified() const {
    std::vector<Cell> cells;
    const auto stops = shortest_route(map().possible(), task());
    for (std::size_t i = 1; i < stops.size(); ++i) {
      const Side side = side_towards(stops[i - 1], stops[i]);
      for (Cell c = stops[i - 1]; c != stops[i]; c = ahead(c, side))
        if (map().state(c, side) == WallState::unknown) cells.push_back(c), cells.push_back(ahead(c, side));
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }
};

struct Named {
  Explorer explorer;
  std::string_view word;
};

constexpr std::array<Named, 9> kNames{{{Explorer::random, "random"},
                                       {Explorer::wall_follower, "wall"},
                                       {Explorer::depth_first, "dfs"},
                                       {Explorer::breadth_first, "bfs"},
                                       {Explorer::flood_fill, "flood"},
                                       {Explorer::a_star, "astar"},
                                       {Explorer::plain_prove, "plain-prove"},
                                       {Explorer::prove, "prove"},
                                       {Explorer::score, "score"}}};

}  // namespace

const std::vector<Explorer>& all_explorers() {
  static const std::vector<Explorer> all = [] {
    std::vector<Explorer> list;
    list.reserve(std::size(kNames));
    for (const Named& n : kNames) list.push_back(n.explorer);
    return list;
  }();
  return all;
}

std::string_view name(Explorer explorer) {
  return std::find_if(kNames.begin(), kNames.end(), [&](const Named& n) { return n.explorer == explorer; })->word;
}

std::optional<Explorer> explorer_named(std::string_view word) {
  for (const Named& n : kNames)
    if (n.word == word) return n.explorer;
  return std::nullopt;
}

bool is_random(Explorer explorer) {
  return explorer == Explorer::random || explorer == Explorer::prove || explorer == Explorer::score;
}

std::unique_ptr<Robot> make_explorer(Explorer explorer, const Task& task, std::uint64_t seed) {
  switch (explorer) {
    case Explorer::random: return std::make_unique<RandomWalker>(task, seed);
    case Explorer::wall_follower: return std::make_unique<WallFollower>(task);
    case Explorer::depth_first: return std::make_unique<DepthFirst>(task);
    case Explorer::breadth_first: return std::make_unique<BreadthFirst>(task);
    case Explorer::flood_fill: return std::make_unique<FloodFill>(task);
    case Explorer::a_star: return std::make_unique<AStar>(task);
    case Explorer::plain_prove: return std::make_unique<PlainProver>(task);
    case Explorer::prove: return std::make_unique<detail::Scout>(task, detail::ScoutGoal::proof, seed);
    case Explorer::score: return std::make_unique<detail::Scout>(task, detail::ScoutGoal::score, seed);
  }
  return nullptr;
}

}  // namespace taut::micromouse
