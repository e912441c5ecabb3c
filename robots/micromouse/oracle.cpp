#include <taut/robots/micromouse/oracle.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <taut/robots/micromouse/detail/boards.h>
#include <taut/robots/micromouse/detail/poses.h>
#include <taut/robots/micromouse/explorers.h>
#include <taut/robots/micromouse/steps.h>
#include <taut/robots/micromouse/trial.h>

namespace taut::micromouse {

namespace {

using detail::cell_of;
using detail::index_of;
using detail::PoseGroup;
using detail::Poses;

constexpr int kMostGroups = 16;  // walks are searched with states of 32 bits

/// What makes the next demand.
class Demands {
 public:
  Demands(const GridMaze& maze, const Task& task, const Poses& poses, int best)
      : task_(task), poses_(poses), truth_(passages_of(maze)), best_(best) {
    for (auto& board : views_) board.assign(poses.count() / 8, 0);
    for (Poses::MousePose p = 0; p < poses.count(); ++p)
      poses.for_each_seen(p, [&](const CellSide& wall, bool) { ++at(views_, wall); });
  }

  PoseGroup goal() const {
    return where([&](Poses::MousePose p) { return task_.in_goal(poses_.cell(p)); });
  }

  /// A demand that this walk does not meet and every proving walk does; empty: the walk proves.
  PoseGroup unmet(const std::vector<Poses::MousePose>& walk) const {
    WallMap map(task_);
    for (const Poses::MousePose p : walk)
      poses_.for_each_seen(p, [&](const CellSide& wall, bool closed) { map.learn(wall.cell, wall.side, closed); });
    // Of the uncut plans one that is far from all of this walk: it costs most.
    const auto far = distance_of_views(walk);
    std::vector<CellSide> plan = easiest_uncut(map, far, 0);
    if (!plan.empty()) {
      for (int least = 1;; ++least) {
        auto further = easiest_uncut(map, far, least);
        if (further.empty()) break;
        plan = std::move(further);
      }
      return showing(plan);
    }
    const auto hi = optimum(map.certain(), task_);
    if (hi && *hi == best_) return {};
    return showing(openings_missing(map));
  }

 private:
  /// A number for each wall.
  using Boards = std::array<std::vector<int>, 2>;

  int& at(Boards& boards, const CellSide& wall) const {
    const CellSide name = canonical(wall);
    return boards[name.side == Side::north || name.side == Side::south][index_of(task_.width, name.cell)];
  }
  int at(const Boards& boards, const CellSide& wall) const { return at(const_cast<Boards&>(boards), wall); }

  /// How many moves the nearest pose that shows a wall is away from the walk.
  Boards distance_of_views(const std::vector<Poses::MousePose>& walk) const {
    constexpr int kFar = std::numeric_limits<int>::max();
    Boards far;
    for (auto& board : far) board.assign(poses_.count() / 8, kFar);
    std::vector<int> moves(poses_.count(), -1);
    std::vector<Poses::MousePose> queue = walk;
    for (const Poses::MousePose p : walk) moves[p] = 0;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const Poses::MousePose here = queue[head];
      poses_.for_each_seen(here,
                           [&](const CellSide& wall, bool) { at(far, wall) = std::min(at(far, wall), moves[here]); });
      for (const Poses::MousePose next : poses_.moves(here))
        if (moves[next] < 0) moves[next] = moves[here] + 1, queue.push_back(next);
    }
    return far;
  }

  template <class Wanted>
  PoseGroup where(Wanted wanted) const {
    PoseGroup group;
    for (Poses::MousePose p = 0; p < poses_.count(); ++p)
      if (wanted(p)) group.push_back(p);
    return group;
  }

  PoseGroup showing(const std::vector<CellSide>& walls) const {
    return where([&](Poses::MousePose p) {
      bool shows = false;
      poses_.for_each_seen(p, [&](const CellSide& wall, bool) {
        shows = shows || std::find(walls.begin(), walls.end(), wall) != walls.end();
      });
      return shows;
    });
  }

  /// The standing walls that a plan below the optimum crosses, none of them seen, with the fewest poses that show one;
  /// empty: there is no such plan. Dynamic programme over (steps, cell).
  /// Walls with a view nearer than `least` moves are left out.
  std::vector<CellSide> easiest_uncut(const WallMap& map, const Boards& far, int least) const {
    const auto w = static_cast<std::size_t>(task_.width);
    const std::size_t cells = truth_.words() == 0 ? 0 : w * static_cast<std::size_t>(task_.height);
    constexpr int kFar = std::numeric_limits<int>::max() / 2;
    std::vector<std::vector<int>> cost(static_cast<std::size_t>(best_), std::vector<int>(cells, kFar));
    std::vector<std::vector<std::size_t>> from(cost.size(), std::vector<std::size_t>(cells));
    cost[0][index_of(task_.width, task_.start)] = 0;
    std::size_t last = 0, goal = cells;
    for (std::size_t s = 1; s < cost.size(); ++s)
      for (std::size_t i = 0; i < cells; ++i) {
        if (cost[s - 1][i] >= kFar) continue;
        for (const Side side : kSides) {
          Cell c = cell_of(task_.width, i);
          int sum = cost[s - 1][i];
          for (int k = 0; k < kLongestMove && map.possible().open(c, side); ++k) {
            if (!truth_.open(c, side)) {
              if (at(far, {c, side}) < least) break;
              sum += at(views_, {c, side});
            }
            c = ahead(c, side);
            const std::size_t j = index_of(task_.width, c);
            if (sum < cost[s][j]) cost[s][j] = sum, from[s][j] = i;
            if (task_.in_goal(c) && sum <= cost[s][j] && (goal == cells || sum < cost[last][goal])) last = s, goal = j;
          }
        }
      }
    std::vector<CellSide> walls;
    if (goal == cells) return walls;
    for (std::size_t s = last, i = goal; s > 0; i = from[s][i], --s) {
      const Cell a = cell_of(task_.width, from[s][i]), b = cell_of(task_.width, i);
      const Side side = side_towards(a, b);
      for (Cell c = a; c != b; c = ahead(c, side))
        if (!truth_.open(c, side)) walls.push_back(canonical({c, side}));
    }
    return walls;
  }

  /// Openings not yet seen of which at least one has to be before a route of the optimum is known: a minimal set.
  std::vector<CellSide> openings_missing(const WallMap& map) const {
    Passages assumed = map.certain();
    std::vector<CellSide> missing;
    for (int y = 0; y < task_.height; ++y)
      for (int x = 0; x < task_.width; ++x)
        for (const Side side : {Side::north, Side::east}) {
          if (!truth_.open({x, y}, side) || assumed.open({x, y}, side)) continue;
          assumed.set({x, y}, side, true);
          const auto hi = optimum(assumed, task_);
          if (!hi || *hi > best_) continue;
          assumed.set({x, y}, side, false);
          missing.push_back({{x, y}, side});
        }
    return missing;
  }

  const Task& task_;
  const Poses& poses_;
  Passages truth_;
  int best_;
  Boards views_;
};

bool within(const PoseGroup& small, const PoseGroup& large) {
  return std::includes(large.begin(), large.end(), small.begin(), small.end());
}

}  // namespace

std::optional<ProofBound> proof_bound(const GridMaze& maze, const OracleLimits& limits) {
  const Task task = task_of(maze);
  const auto best = optimum(passages_of(maze), task);
  if (!best) return std::nullopt;
  const Poses poses(maze, task);
  const Demands demands(maze, task, poses, *best);
  std::vector<PoseGroup> groups{demands.goal()};
  ProofBound bound{*best, *best + 1, false};
  for (;;) {
    const auto walk = shortest_walk(poses, groups);
    bound.run1 = std::max(bound.run1, static_cast<int>(walk.size()));
    const PoseGroup next = demands.unmet(walk);
    if (next.empty()) {
      bound.exact = bound.run1 == static_cast<int>(walk.size());
      return bound;
    }
    // A wider demand is met with the narrower one.
    std::erase_if(groups, [&](const PoseGroup& g) { return within(next, g); });
    if (static_cast<int>(groups.size()) >= std::min(limits.groups, kMostGroups)) return bound;
    groups.push_back(next);
  }
}

std::optional<double> absolute_floor(const GridMaze& maze) {
  const auto best = optimum(passages_of(maze), task_of(maze));
  if (!best) return std::nullopt;
  return *best + static_cast<double>(*best + 1) / kExplorationShare;
}

std::optional<double> benchmark_every_cell(const GridMaze& maze) {
  const auto best = optimum(passages_of(maze), task_of(maze));
  if (!best) return std::nullopt;
  return *best + static_cast<double>(maze.width()) * maze.height() / kExplorationShare;
}

std::optional<double> benchmark_random_walkers(const GridMaze& maze) {
  constexpr int kWanted = 10, kTries = 1000;
  int sum = 0, finished = 0;
  for (int seed = 1; seed <= kTries && finished < kWanted; ++seed) {
    const auto robot = make_explorer(Explorer::random, task_of(maze), static_cast<std::uint64_t>(seed));
    const auto score = run_trial(maze, *robot).thirtieths();
    if (score) sum += *score, ++finished;
  }
  if (finished < kWanted) return std::nullopt;
  return static_cast<double>(sum) / (kWanted * kExplorationShare);
}

}  // namespace taut::micromouse
