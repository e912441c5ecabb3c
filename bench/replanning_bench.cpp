// A robot with short sight walks through a grid it does not know: D* Lite, which repairs, against A* from scratch,
// which begins again, either each time something new is seen or, with the benefit of knowing that walls are only ever
// added, only when they lie on its path. Before anything is timed a walk is made in which both are asked at every step,
// and their costs must be equal.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <vector>

#include <taut/search/dstar_lite.h>

namespace {

constexpr int kSight = 3;  // cells to each side
constexpr int kNoPath = std::numeric_limits<int>::max();

/// 4 neighbours, unit steps.
struct Grid {
  using State = int;
  using Cost = int;

  int width = 0, height = 0;
  std::vector<std::uint8_t> blocked;

  Grid(int w, int h) : width(w), height(h), blocked(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  bool is_blocked(int s) const { return blocked[static_cast<std::size_t>(s)] != 0; }
  void set(int s, bool wall) { blocked[static_cast<std::size_t>(s)] = wall; }

  std::size_t state_count() const { return blocked.size(); }
  void each_neighbour(int s, auto&& visit) const {
    const int x = s % width, y = s / width;
    if (x + 1 < width) visit(s + 1);
    if (y + 1 < height) visit(s + width);
    if (x > 0) visit(s - 1);
    if (y > 0) visit(s - width);
  }
  void each_out(int s, auto&& visit) const {
    if (is_blocked(s)) return;
    each_neighbour(s, [&](int t) {
      if (!is_blocked(t)) visit(t, 1);
    });
  }
  void each_in(int s, auto&& visit) const { each_out(s, visit); }
  int heuristic(int s, int t) const { return std::abs(s % width - t % width) + std::abs(s / width - t / width); }
};

/// Corridors one cell wide (depth-first spanning tree), every eighth of the walls between two corridors taken down.
Grid maze(int cells) {
  Grid grid(2 * cells + 1, 2 * cells + 1);
  std::mt19937_64 draw(7);
  for (int s = 0; s < grid.width * grid.height; ++s) grid.set(s, true);
  const auto at = [&](int x, int y) { return (2 * y + 1) * grid.width + 2 * x + 1; };
  std::vector<std::array<int, 2>> stack{{0, 0}};
  grid.set(at(0, 0), false);
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    std::vector<std::array<int, 2>> ways;
    for (const auto [dx, dy] : {std::array{1, 0}, std::array{0, 1}, std::array{-1, 0}, std::array{0, -1}}) {
      const int u = x + dx, v = y + dy;
      if (u >= 0 && v >= 0 && u < cells && v < cells && grid.is_blocked(at(u, v))) ways.push_back({u, v});
    }
    if (ways.empty()) {
      stack.pop_back();
      continue;
    }
    const auto [u, v] = ways[draw() % ways.size()];
    grid.set((at(x, y) + at(u, v)) / 2, false);
    grid.set(at(u, v), false);
    stack.push_back({u, v});
  }
  for (int y = 1; y + 1 < grid.height; ++y)
    for (int x = 1; x + 1 < grid.width; ++x)
      if ((x + y) % 2 == 1 && draw() % 8 == 0) grid.set(y * grid.width + x, false);
  return grid;
}

/// Every fourth cell blocked, at random, but for the corners where the walk begins and ends.
Grid clutter(int cells) {
  Grid grid(cells, cells);
  std::mt19937_64 draw(11);
  for (int s = 0; s < cells * cells; ++s) grid.set(s, draw() % 4 == 0);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      for (const int s : {y * cells + x, (cells - 1 - y) * cells + cells - 1 - x}) grid.set(s, false);
  return grid;
}

/// What a robot at `at` sees that it did not know: walls, added to `known`.
std::vector<int> look(const Grid& truth, Grid& known, int at) {
  std::vector<int> seen;
  const int x = at % truth.width, y = at / truth.width;
  for (int v = std::max(0, y - kSight); v <= std::min(truth.height - 1, y + kSight); ++v)
    for (int u = std::max(0, x - kSight); u <= std::min(truth.width - 1, x + kSight); ++u)
      if (const int s = v * truth.width + u; truth.is_blocked(s) && !known.is_blocked(s)) {
        known.set(s, true);
        seen.push_back(s);
      }
  return seen;
}

struct DrivePlan {
  int cost = kNoPath;
  std::vector<int> path;
  std::size_t expanded = 0;
};

/// A* in flat arrays, kept between searches; ties go to the cell nearer to the goal.
class AStar {
 public:
  explicit AStar(const Grid& grid) : cost_(grid.blocked.size()), round_(cost_.size()), before_(cost_.size()) {}

  DrivePlan operator()(const Grid& grid, int start, int goal) {
    ++now_;
    DrivePlan plan;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    put(start, 0, start);
    open.push({grid.heuristic(start, goal), grid.heuristic(start, goal), start});
    while (!open.empty()) {
      const auto [key, rest, s] = open.top();
      open.pop();
      if (key - rest != cost_[index(s)]) continue;
      if (s == goal) {
        plan.cost = cost_[index(s)];
        for (int t = goal; t != start; t = before_[index(t)]) plan.path.push_back(t);
        return plan;  // the next step is the last
      }
      ++plan.expanded;
      grid.each_out(s, [&, from = s](int t, int edge) {
        const int cost = cost_[index(from)] + edge;
        if (round_[index(t)] == now_ && cost_[index(t)] <= cost) return;
        put(t, cost, from);
        open.push({cost + grid.heuristic(t, goal), grid.heuristic(t, goal), t});
      });
    }
    return plan;
  }

 private:
  using Entry = std::array<int, 3>;
  static std::size_t index(int s) { return static_cast<std::size_t>(s); }
  void put(int s, int cost, int from) {
    cost_[index(s)] = cost;
    before_[index(s)] = from;
    round_[index(s)] = now_;
  }

  std::vector<int> cost_;
  std::vector<unsigned> round_;
  std::vector<int> before_;
  unsigned now_ = 0;
};

struct Walk {
  std::size_t expanded = 0, replans = 0, steps = 0;
};

void tell(taut::DstarLite<Grid>& search, const Grid& known, const std::vector<int>& seen) {
  for (const int s : seen) {
    search.changed(s);
    known.each_neighbour(s, [&](int t) { search.changed(t); });
  }
}

Walk walk_with_dstar(const Grid& truth, int start, int goal, bool checked) {
  Grid known(truth.width, truth.height);
  AStar astar(known);
  look(truth, known, start);
  taut::DstarLite<Grid> search(known, start, goal);
  Walk walk;
  for (int at = start;;) {
    const taut::SearchStatus status = search.replan();
    walk.expanded += search.expanded();
    walk.replans += search.expanded() > 0;
    if (checked && astar(known, at, goal).cost != (status == taut::SearchStatus::found ? search.cost() : kNoPath))
      std::abort();
    if (status != taut::SearchStatus::found) std::abort();
    if (at == goal) return walk;
    at = search.next();
    if (truth.is_blocked(at)) std::abort();
    ++walk.steps;
    search.move_to(at);
    tell(search, known, look(truth, known, at));
  }
}

Walk walk_with_astar(const Grid& truth, int start, int goal, bool only_when_blocked) {
  Grid known(truth.width, truth.height);
  AStar astar(known);
  look(truth, known, start);
  Walk walk;
  DrivePlan plan;
  bool is_due = true;
  for (int at = start; at != goal;) {
    if (is_due) {
      plan = astar(known, at, goal);
      walk.expanded += plan.expanded;
      ++walk.replans;
      if (plan.cost == kNoPath) std::abort();
    }
    at = plan.path.back();
    plan.path.pop_back();
    ++walk.steps;
    is_due = !look(truth, known, at).empty();
    if (only_when_blocked)
      is_due = std::any_of(plan.path.begin(), plan.path.end(), [&](int s) { return known.is_blocked(s); });
  }
  return walk;
}

struct Scene {
  Grid truth;
  int start, goal;
};

Scene scene(Grid (*make)(int), int cells) {
  Grid grid = make(cells);
  const int start = grid.width + 1, goal = grid.width * (grid.height - 1) - 2;
  return {std::move(grid), start, goal};
}

void report(benchmark::State& state, const Walk& walk) {
  state.counters["expanded"] = static_cast<double>(walk.expanded);
  state.counters["replans"] = static_cast<double>(walk.replans);
  state.counters["steps"] = static_cast<double>(walk.steps);
}

void dstar_lite(benchmark::State& state, Grid (*make)(int)) {
  const Scene s = scene(make, static_cast<int>(state.range(0)));
  walk_with_dstar(s.truth, s.start, s.goal, true);
  Walk walk;
  for (auto _ : state) walk = walk_with_dstar(s.truth, s.start, s.goal, false);
  report(state, walk);
}

void astar(benchmark::State& state, Grid (*make)(int), bool only_when_blocked) {
  const Scene s = scene(make, static_cast<int>(state.range(0)));
  Walk walk;
  for (auto _ : state) walk = walk_with_astar(s.truth, s.start, s.goal, only_when_blocked);
  report(state, walk);
}

BENCHMARK_CAPTURE(dstar_lite, maze, maze)->Arg(25)->Arg(75)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(astar, maze_each_time, maze, false)->Arg(25)->Arg(75)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(astar, maze_when_blocked, maze, true)->Arg(25)->Arg(75)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dstar_lite, clutter, clutter)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(astar, clutter_each_time, clutter, false)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(astar, clutter_when_blocked, clutter, true)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);

}  // namespace
