#include <taut/search/anytime_search.h>

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/roadmaps/prm.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/prm_planner.h>
#include <taut/search/shortest_path.h>

#include "support/lattice.h"
#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using Vertex = Roadmap::Vertex;
using Edges = std::vector<std::pair<Vertex, Vertex>>;
using Map = std::shared_ptr<const Roadmap>;

GraphQuery between(const Roadmap& map, Vertex from, Vertex to) {
  return {.start = {map.point(from), {from}}, .goals = {{map.point(to), {to}}}, .direct = {}};
}

/// The path straight ahead looks good for long and is a detour in the end; A* with a heavy heuristic takes it.
///
///         4 ---------- 5
///         |             |
///   0 --- 1 --- 2 - 3   6       3 lies near the goal, and the way on from it leads back and around
Map tempting() {
  return std::make_shared<const Roadmap>(
      std::vector<Point>{{0, 0}, {2, 0}, {6, 0}, {9, 0}, {2, 2}, {10, 2}, {10, 0}, {9, -6}},
      Edges{{0, 1}, {1, 2}, {2, 3}, {1, 4}, {4, 5}, {5, 6}, {3, 7}, {7, 6}});
}

/// `length` is at most `bound` times `exact`: the exact lengths as enclosed, the product rounded against the claim.
bool keeps(const Length& length, double bound, const Length& exact) {
  if (bound == 1) return length == exact;
  return length >= exact && length.interval().lo <= std::nextafter(bound * exact.interval().hi, HUGE_VAL);
}

/// Runs a search to its end and checks every stage, against the exact search.
void require_right(const Map& map, const GraphQuery& query, double epsilon, const SearchLimits& limits) {
  const GraphSearchResult exact = graph_search(*map, query);
  AnytimeSearch search(map, query, epsilon);
  double bound = HUGE_VAL;
  for (int calls = 0; !search.optimal(); ++calls) {
    RC_ASSERT(calls < 100'000);
    const SearchStatus status = search.improve(limits);
    if (status == SearchStatus::none) {
      RC_ASSERT(exact.status == SearchStatus::none);
      RC_ASSERT(search.best().points.empty());
      RC_ASSERT(search.improve() == SearchStatus::none);
      return;
    }
    RC_ASSERT(search.bound() >= 1);
    if (status == SearchStatus::stopped) {
      RC_ASSERT(search.bound() <= bound);
    } else {
      RC_ASSERT(search.bound() <= search.epsilon());
      RC_ASSERT(search.bound() < bound || (limits.expansions < SIZE_MAX && search.bound() == bound));
    }
    bound = search.bound();
    const Path best = search.best();
    if (best.points.empty()) {
      RC_ASSERT(status == SearchStatus::stopped && bound == HUGE_VAL);
      continue;
    }
    RC_ASSERT(exact.status == SearchStatus::found);
    RC_ASSERT(best.points.front() == query.start.point);
    RC_ASSERT(best.points.back() == query.goals[search.goal()].point);
    RC_ASSERT(keeps(best.length, bound, exact.path.length));
  }
  RC_ASSERT(exact.status == SearchStatus::found);
  RC_ASSERT(search.bound() == 1);
  RC_ASSERT(search.best().length == exact.path.length);
  RC_ASSERT(search.improve() == SearchStatus::found);
}

double any_epsilon() { return *rc::gen::element(1.0, 1.01, 1.5, 3.0, 10.0, 1e6); }

SearchLimits any_limits() {
  return {.expansions = any(0, 1) ? SIZE_MAX : static_cast<std::size_t>(any(1, 9)), .seconds = 1e300};
}

TEST(AnytimeSearch, TakesTheTemptingWayFirstAndTheShortestInTheEnd) {
  const Map map = tempting();
  AnytimeSearch search(map, between(*map, 0, 6), 10);
  ASSERT_EQ(search.improve(), SearchStatus::found);
  EXPECT_EQ(search.best().points[3], (Point{9, 0}));
  EXPECT_GT(search.bound(), 1.5);
  const auto first = search.latest();
  EXPECT_EQ(first.epsilon, 10);
  EXPECT_EQ(first.length, search.best().length);
  while (!search.optimal()) ASSERT_EQ(search.improve(), SearchStatus::found);
  EXPECT_EQ(search.best().length.value(), 14);
  EXPECT_EQ(search.bound(), 1);
  EXPECT_GT(search.expanded(), first.expanded);
}

TEST(AnytimeSearch, ComesBackToWhatItFoundAShorterWayToTooLate) {
  //              4             0 start, 5 goal. The pull takes 1 and 3 first; then 2, by which 3 is nearer, though it
  //       1                    is closed in this round; then 4 and the goal. The way by 2 counts all the same.
  //   0       3      5
  //     2
  const auto map =
      std::make_shared<const Roadmap>(std::vector<Point>{{0, 0}, {8, 5}, {1, -3}, {10, 0}, {10, 20}, {20, 0}},
                                      Edges{{0, 1}, {1, 3}, {0, 2}, {2, 3}, {3, 4}, {4, 5}});
  AnytimeSearch search(map, between(*map, 0, 5), 10);
  ASSERT_EQ(search.improve(), SearchStatus::found);
  EXPECT_FALSE(search.optimal());
  EXPECT_EQ(search.best().points[1], (Point{8, 5}));
  while (!search.optimal()) ASSERT_EQ(search.improve(), SearchStatus::found);
  EXPECT_EQ(search.best().points[1], (Point{1, -3}));
  EXPECT_EQ(search.best().length, graph_search(*map, between(*map, 0, 5)).path.length);
}

TEST(AnytimeSearch, IsAStarWhenEpsilonIsOne) {
  const Map map = std::make_shared<const Roadmap>(test::lattice(40));
  AnytimeSearch search(map, between(*map, 3, 1590), 1);
  ASSERT_EQ(search.improve(), SearchStatus::found);
  EXPECT_TRUE(search.optimal());
  EXPECT_EQ(search.best().length, graph_search(*map, between(*map, 3, 1590)).path.length);
}

TEST(AnytimeSearch, ProvesThatThereIsNone) {
  const auto map = std::make_shared<const Roadmap>(std::vector<Point>{{0, 0}, {1, 0}, {5, 0}}, Edges{{0, 1}});
  AnytimeSearch search(map, between(*map, 0, 2));
  EXPECT_EQ(search.improve(), SearchStatus::none);
  EXPECT_FALSE(search.optimal());
  EXPECT_EQ(search.bound(), HUGE_VAL);
  AnytimeSearch no_goal(map, {.start = {{0, 0}, {0}}, .goals = {}, .direct = {}});
  EXPECT_EQ(no_goal.improve(), SearchStatus::none);
}

TEST(AnytimeSearch, IsOnePointWhenTheStartIsTheGoal) {
  const auto map = std::make_shared<const Roadmap>();
  AnytimeSearch search(map, {.start = {{2, 3}, {}}, .goals = {{{2, 3}, {}}}, .direct = {0}});
  ASSERT_EQ(search.improve(), SearchStatus::found);
  EXPECT_TRUE(search.optimal());
  EXPECT_EQ(search.best().points, (std::vector<Point>{{2, 3}}));
}

TEST(AnytimeSearch, StopsAtALimitAndGoesOn) {
  const Map map = std::make_shared<const Roadmap>(test::lattice(60));
  const GraphQuery query = between(*map, 0, 60 * 20 + 59);
  AnytimeSearch whole(map, query), pieces(map, query);
  EXPECT_EQ(pieces.improve({.seconds = 0}), SearchStatus::stopped);
  EXPECT_EQ(pieces.expanded(), 0U);
  EXPECT_TRUE(pieces.best().points.empty());
  while (!whole.optimal()) whole.improve();
  while (!pieces.optimal()) pieces.improve({.expansions = 7});
  EXPECT_EQ(pieces.best().points, whole.best().points);
  EXPECT_EQ(pieces.expanded(), whole.expanded());
}

TEST(AnytimeSearch, FindsAFirstPathWithFarFewerExpansions) {
  const Map map = std::make_shared<const Roadmap>(test::lattice(80));
  // Off the diagonals all ways of many legs are tied: A* has to look at the whole parallelogram between the ends.
  const GraphQuery query = between(*map, 80 * 10 + 10, 80 * 40 + 70);
  AnytimeSearch search(map, query);
  search.improve();
  const std::size_t first = search.expanded();
  EXPECT_LT(first * 5, graph_search(*map, query, GraphAlgorithm::dijkstra).expanded);
  EXPECT_LE(search.bound(), 3);
}

TEST(AnytimeSearch, DecidesADifferenceBelowTheRoundingOfTheLength) {
  const double far = 0x1p20, thin = 0x1p-40;
  const auto map = std::make_shared<const Roadmap>(
      std::vector<Point>{{0, 0}, {far, 0}, {far + 1, thin * 1.5}, {far + 1, -thin}, {far + 2, 0}},
      Edges{{0, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 4}});
  AnytimeSearch search(map, between(*map, 0, 4));
  while (!search.optimal()) search.improve();
  EXPECT_EQ(search.best().points[2].y, -thin);
}

/// Few lattice points, many of them equal, so that nearly everything is tied; or far away, where bounds cannot order
/// what is tiny.
RC_GTEST_PROP(AnytimeSearch, KeepsItsBoundsOnGraphsFullOfTies, ()) {
  const auto n = static_cast<Vertex>(any(1, 14));
  const int range = any(0, 5);
  const double unit = *rc::gen::element(1.0, 0.1, 0x1p-30), far = *rc::gen::element(0.0, 0x1p22);
  const auto any_point = [&] {
    const int x = any(0, range), y = any(0, range);
    return Point{x * unit, y * unit};
  };
  std::vector<Point> points;
  for (Vertex v = 0; v < n; ++v) points.push_back(any_point());
  const auto any_vertex = [&] { return static_cast<Vertex>(any(0, static_cast<int>(n) - 1)); };
  Edges edges;
  for (int k = any(0, static_cast<int>(3 * n)); k > 0; --k) {
    const Vertex u = any_vertex(), v = any_vertex();
    edges.emplace_back(u, v);
  }
  const auto any_end = [&](double x) {
    Terminal end{any_point(), {}};
    end.point.x += x;
    for (int k = any(0, 3); k > 0; --k) end.vertices.push_back(any_vertex());
    return end;
  };
  GraphQuery query{.start = any_end(-far), .goals = {}, .direct = {}};
  for (int goals = any(0, 3); goals > 0; --goals) {
    if (any(0, 8) == 0) query.direct.push_back(query.goals.size());
    query.goals.push_back(any_end(0));
  }
  require_right(std::make_shared<const Roadmap>(points, edges), query, any_epsilon(), any_limits());
}

GraphQuery seen(const VisibilityGraph& graph, Point from, Point to) {
  GraphQuery query{{from, graph.visible_from(from)}, {{to, graph.visible_from(to)}}, {}};
  if (graph.space().sees(from, to)) query.direct.push_back(0);
  return query;
}

Point any_place(const FreeSpace& space, int side) {
  const Point p = test::any_lattice_point(side);
  RC_PRE(space.locate(p).kind != Location::Kind::outside);
  return p;
}

RC_GTEST_PROP(AnytimeSearch, EndsWithTheShortestPathOfVisibilityGraphs, ()) {
  const test::SmallWorld world = test::any_world({.side = 8, .walls = 14});
  const FreeSpace space = world.space();
  const Point from = any_place(space, 8), to = any_place(space, 8);
  const auto graph = std::make_shared<const VisibilityGraph>(space);
  require_right({graph, &graph->roadmap()}, seen(*graph, from, to), any_epsilon(), any_limits());
}

RC_GTEST_PROP(AnytimeSearch, EndsWithTheShortestPathOfRandomRoadmaps, ()) {
  const test::SmallWorld world = test::any_world({.side = 8, .walls = 10});
  const FreeSpace space = world.space();
  const Point from = any_place(space, 8), to = any_place(space, 8);
  PrmOptions options;
  options.samples = static_cast<std::size_t>(any(5, 200));
  options.seed = static_cast<std::uint64_t>(any(1, 1000));
  if (any(0, 2) == 0) options.sampler = PrmSampler::lattice;
  const auto map = std::make_shared<const Roadmap>(prm(space, options));
  require_right(map, prm_query(space, *map, from, {to, {}}), any_epsilon(), any_limits());
}

}  // namespace
}  // namespace taut
