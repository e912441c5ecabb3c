#include <taut/search/dstar_lite.h>

#include <array>
#include <map>
#include <queue>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "support/random_world.h"

namespace taut {
namespace {

using test::any;

/// A grid, 4 neighbours, unit steps, known as far as walls were found. Never written down as a graph.
struct Grid {
  using State = int;  // y * width + x
  using Cost = int;

  int width = 1, height = 1;
  std::set<int> blocked;

  void each_out(int s, auto&& visit) const {
    const int x = s % width, y = s / width;
    for (const auto [dx, dy] : {std::array{1, 0}, std::array{0, 1}, std::array{-1, 0}, std::array{0, -1}}) {
      const int u = x + dx, v = y + dy;
      if (u < 0 || v < 0 || u >= width || v >= height) continue;
      const int t = v * width + u;
      if (!blocked.contains(s) && !blocked.contains(t)) visit(t, 1);
    }
  }
  void each_in(int s, auto&& visit) const { each_out(s, visit); }
  int heuristic(int s, int t) const { return std::abs(s % width - t % width) + std::abs(s / width - t / width); }
};

/// A directed graph of numbered states; heuristic 0, or one that a potential gives.
template <class Number>
struct Graph {
  using State = int;
  using Cost = Number;

  std::vector<std::map<int, Number>> out, in;
  std::vector<Number> potential;  // heuristic(s, t) = potential[s] - potential[t], where positive

  explicit Graph(int n) : out(static_cast<std::size_t>(n)), in(out.size()), potential(out.size()) {}
  std::size_t state_count() const { return out.size(); }
  void set(int s, int t, Number cost) {
    out[static_cast<std::size_t>(s)][t] = cost;
    in[static_cast<std::size_t>(t)][s] = cost;
  }
  void erase(int s, int t) {
    out[static_cast<std::size_t>(s)].erase(t);
    in[static_cast<std::size_t>(t)].erase(s);
  }
  void each_out(int s, auto&& visit) const {
    for (const auto& [t, cost] : out[static_cast<std::size_t>(s)]) visit(t, cost);
  }
  void each_in(int s, auto&& visit) const {
    for (const auto& [t, cost] : in[static_cast<std::size_t>(s)]) visit(t, cost);
  }
  Number heuristic(int s, int t) const {
    const Number difference = potential[static_cast<std::size_t>(s)] - potential[static_cast<std::size_t>(t)];
    return difference > 0 ? difference : 0;
  }
};

/// From scratch, backwards from the goal: what every answer is compared with.
template <class G>
std::map<int, typename G::Cost> dijkstra(const G& graph, int goal) {
  using Cost = typename G::Cost;
  std::map<int, Cost> final;
  std::priority_queue<std::pair<Cost, int>, std::vector<std::pair<Cost, int>>, std::greater<>> open;
  for (open.emplace(Cost{}, goal); !open.empty();) {
    const auto [cost, s] = open.top();
    open.pop();
    if (!final.emplace(s, cost).second) continue;
    graph.each_in(s, [&, c = cost](int t, Cost edge) {
      if (edge != NumberCosts<Cost>::infinity()) open.emplace(edge + c, t);
    });
  }
  return final;
}

static_assert(!NumberedGraph<Grid> && NumberedGraph<Graph<int>>, "both ways to find a state are tested");

template <class G>
void require_right(const G& graph, DstarLite<G>& search) {
  const auto exact = dijkstra(graph, search.goal());
  const SearchStatus status = search.replan({.expansions = 100'000});
  const auto found = exact.find(search.start());
  RC_ASSERT((status == SearchStatus::found) == (found != exact.end()));
  if (status != SearchStatus::found) {
    RC_ASSERT(status == SearchStatus::none);
    RC_ASSERT(search.path().empty());
    return;
  }
  RC_ASSERT(search.cost() == found->second);
  // The path is one, and costs what is said, added up from the goal as the search does.
  const std::vector<int> path = search.path();
  RC_ASSERT(path.front() == search.start());
  RC_ASSERT(path.back() == search.goal());
  typename G::Cost sum{};
  for (std::size_t i = path.size() - 1; i > 0; --i) {
    typename G::Cost least = NumberCosts<typename G::Cost>::infinity();
    graph.each_out(path[i - 1], [&](int t, typename G::Cost edge) {
      if (t == path[i] && edge < least) least = edge;
    });
    RC_ASSERT(least != NumberCosts<typename G::Cost>::infinity());
    sum = least + sum;
  }
  RC_ASSERT(sum == search.cost());
}

TEST(DstarLite, GoesAroundAWallThatTurnsUp) {
  // . . .
  // S # G      the middle turns out to be blocked
  // . # .
  Grid grid{3, 3, {}};
  DstarLite<Grid> search(grid, 3, 5);
  EXPECT_EQ(search.replan(), SearchStatus::found);
  EXPECT_EQ(search.path(), (std::vector{3, 4, 5}));
  for (const int wall : {4, 1}) {
    grid.blocked.insert(wall);
    for (int s = 0; s < 9; ++s) search.changed(s);
  }
  ASSERT_EQ(search.replan(), SearchStatus::found);
  ASSERT_EQ(search.cost(), 4);
  EXPECT_EQ(search.path(), (std::vector{3, 6, 7, 8, 5}));
}

TEST(DstarLite, TellsTheWholeCorridorWhenItsFarEndTurnsOutToBeBlocked) {
  // S . . . . # G     The wall at # is far from S: all before it learn only from each other that they are dearer now.
  // . # # # # # .     Costs are looked at before any path, which would lead to and fro for ever if they did not.
  // . . . . . . .
  Grid grid{7, 3, {8, 9, 10, 11, 12}};
  DstarLite<Grid> search(grid, 0, 6);
  ASSERT_EQ(search.replan({.expansions = 1000}), SearchStatus::found);
  ASSERT_EQ(search.cost(), 6);
  grid.blocked.insert(5);
  for (const int s : {4, 5, 6}) search.changed(s);
  ASSERT_EQ(search.replan({.expansions = 1000}), SearchStatus::found);
  ASSERT_EQ(search.cost(), 10);
  EXPECT_EQ(search.path(), (std::vector{0, 7, 14, 15, 16, 17, 18, 19, 20, 13, 6}));
}

TEST(DstarLite, ProvesThatNoPathIsLeftAndFindsOneAgain) {
  Grid grid{3, 1, {1}};
  DstarLite<Grid> search(grid, 0, 2);
  EXPECT_EQ(search.replan(), SearchStatus::none);
  EXPECT_TRUE(search.path().empty());
  grid.blocked.clear();
  for (int s = 0; s < 3; ++s) search.changed(s);
  EXPECT_EQ(search.replan(), SearchStatus::found);
  EXPECT_EQ(search.cost(), 2);
}

TEST(DstarLite, IsThereWhenStartIsTheGoal) {
  Grid grid{2, 2, {}};
  DstarLite<Grid> search(grid, 3, 3);
  EXPECT_EQ(search.replan(), SearchStatus::found);
  EXPECT_EQ(search.cost(), 0);
  EXPECT_EQ(search.path(), std::vector{3});
}

TEST(DstarLite, StopsAtALimitAndGoesOn) {
  Grid grid{30, 30, {}};
  DstarLite<Grid> search(grid, 0, 899);
  int rounds = 0;
  while (search.replan({.expansions = 5}) == SearchStatus::stopped) ++rounds;
  EXPECT_GT(rounds, 3);
  EXPECT_EQ(search.cost(), 58);
}

TEST(DstarLite, LooksAtLessThanTheWholeGridWhenAWallTurnsUpNearTheStart) {
  Grid grid{100, 100, {}};
  DstarLite<Grid> search(grid, 0, 9999);
  search.replan();
  grid.blocked = {1};
  for (const int s : {0, 1, 2, 101}) search.changed(s);
  search.replan();
  EXPECT_EQ(search.cost(), 198);
  EXPECT_LT(search.expanded(), 20U);
}

TEST(DstarLite, LooksAtNoMoreThanAStraightWayWhereNothingIsInTheWay) {
  // All cells of the rectangle between start and goal have the same estimate.
  Grid grid{100, 100, {}};
  DstarLite<Grid> search(grid, 0, 9999);
  ASSERT_EQ(search.replan(), SearchStatus::found);
  EXPECT_EQ(search.cost(), 198);
  EXPECT_LT(search.expanded(), 400U);
}

RC_GTEST_PROP(DstarLite, AgreesWithDijkstraWhileARobotDiscoversAGrid, ()) {
  const int width = any(1, 9), height = any(1, 9), cells = width * height;
  Grid truth{width, height, {}}, known{width, height, {}};
  for (int n = any(0, cells / 2); n > 0; --n) truth.blocked.insert(any(0, cells - 1));
  const int start = any(0, cells - 1), goal = any(0, cells - 1);
  DstarLite<Grid> search(known, start, goal);
  for (int steps = 0; steps < 4 * cells; ++steps) {
    require_right(known, search);
    if (search.path().size() < 2) return;
    const int next = search.next();
    if (!truth.blocked.contains(next)) {
      search.move_to(next);
      continue;
    }
    known.blocked.insert(next);
    search.changed(next);
    Grid{width, height, {}}.each_out(next, [&](int s, int) { search.changed(s); });
  }
}

template <class Number>
void change_at_random(Number (*any_cost)(), bool informed) {
  const int n = any(2, 9);
  Graph<Number> graph(n);
  if (informed)
    for (Number& p : graph.potential) p = static_cast<Number>(any(0, 8));
  const auto any_edge = [&] {
    const int s = any(0, n - 1), t = any(0, n - 1);
    // No cheaper than what the heuristic counts on.
    if (s != t) graph.set(s, t, graph.heuristic(s, t) + any_cost());
    return s;
  };
  for (int k = any(0, 3 * n); k > 0; --k) any_edge();
  DstarLite<Graph<Number>> search(graph, any(0, n - 1), any(0, n - 1));
  for (int round = 0; round < 8; ++round) {
    require_right(graph, search);
    for (int k = any(0, 4); k > 0; --k) {
      const int s = any(0, n - 1), kind = any(0, 3);
      if (kind == 0) {
        search.changed(any_edge());
      } else if (auto& row = graph.out[static_cast<std::size_t>(s)]; !row.empty()) {
        const int t = std::next(row.begin(), any(0, static_cast<int>(row.size()) - 1))->first;
        if (kind == 1) graph.erase(s, t);
        if (kind == 2) graph.set(s, t, graph.heuristic(s, t) + any_cost());
        if (kind == 3) graph.set(s, t, NumberCosts<Number>::infinity());
        search.changed(s);
      }
    }
    if (any(0, 2) == 0) search.move_to(any(0, n - 1));
    if (any(0, 9) == 0) search.restart(any(0, n - 1), any(0, n - 1));
  }
}

RC_GTEST_PROP(DstarLite, AgreesWithDijkstraExactlyWithIntegers, ()) {
  change_at_random<int>([] { return any(1, 6); }, any(0, 1) == 1);
}

RC_GTEST_PROP(DstarLite, AgreesWithDijkstraToTheBitWithDoubles, ()) {
  change_at_random<double>([] { return any(1, 1000) / 700.0 + 0.1; }, any(0, 1) == 1);
}

}  // namespace
}  // namespace taut
