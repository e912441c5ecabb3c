// Searches by their textbook names, and what they may say of the path they find.
#include <taut/search/graph_heuristics.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <taut/search/graph_search.h>

#include "support/bellman_ford.h"
#include "support/graph_case.h"
#include "support/lattice.h"

namespace taut {
namespace {

using Vertex = Roadmap::Vertex;
using Edges = std::vector<std::pair<Vertex, Vertex>>;

constexpr GraphHeuristic kHeuristics[] = {GraphHeuristic::euclidean, GraphHeuristic::manhattan, GraphHeuristic::octile,
                                          GraphHeuristic::chebyshev, GraphHeuristic::zero};

std::vector<GraphMethod> all_methods() {
  std::vector<GraphMethod> methods{GraphAlgorithm::dijkstra, GraphAlgorithm::bfs, GraphAlgorithm::dfs};
  for (const GraphAlgorithm algorithm : {GraphAlgorithm::astar, GraphAlgorithm::greedy})
    for (const GraphHeuristic heuristic : kHeuristics) methods.emplace_back(algorithm, heuristic);
  return methods;
}

GraphQuery between(const Roadmap& map, Vertex from, Vertex to) {
  return {.start = {map.point(from), {from}}, .goals = {{map.point(to), {to}}}, .direct = {}};
}

//            4       over 1 it is 1 + 5 = 6, over 2 and 3 it is 3 sqrt(2) + 2 = 6.24. But Manhattan says 7 of 1, from
//         2  3       where 5 are left, and so the other way is at the goal before 1 looks good.
//   1
//   0
const Roadmap& two_ways() {
  static const Roadmap map({{0, 0}, {0, 1}, {3, 3}, {4, 3}, {4, 4}}, Edges{{0, 1}, {1, 4}, {0, 2}, {2, 3}, {3, 4}});
  return map;
}

TEST(GraphMethod, ManhattanOnStraightLegsMissesTheShortestPathAndIsSaidTo) {
  const auto shortest = graph_search(two_ways(), between(two_ways(), 0, 4));
  EXPECT_EQ(shortest.path.points, (std::vector<Point>{{0, 0}, {0, 1}, {4, 4}}));
  EXPECT_TRUE(shortest.optimal);
  EXPECT_FALSE(shortest.overestimate);
  const auto missed =
      graph_search(two_ways(), between(two_ways(), 0, 4), {GraphAlgorithm::astar, GraphHeuristic::manhattan});
  EXPECT_EQ(missed.status, SearchStatus::found);
  EXPECT_EQ(missed.path.points, (std::vector<Point>{{0, 0}, {3, 3}, {4, 3}, {4, 4}}));
  EXPECT_FALSE(missed.optimal);
  EXPECT_EQ(missed.overestimate, (GraphOverestimate{{0, 0}, 8, 6}));
}

TEST(GraphMethod, WithManhattanIsNotCalledOptimalWhereItHappensToBe) {
  const Roadmap map({{0, 0}, {3, 4}}, Edges{{0, 1}});
  const auto result = graph_search(map, between(map, 0, 1), {GraphAlgorithm::astar, GraphHeuristic::manhattan});
  EXPECT_EQ(result.path.length.value(), 5);
  EXPECT_FALSE(result.optimal);
  EXPECT_EQ(result.overestimate, (GraphOverestimate{{0, 0}, 7, 5}));
}

TEST(GraphMethod, ManhattanIsAdmissibleWhereLegsFollowTheAxes) {
  const Roadmap square({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, Edges{{0, 1}, {0, 2}, {1, 3}, {2, 3}});
  auto query = between(square, 0, 3);
  const GraphMethod manhattan{GraphAlgorithm::astar, GraphHeuristic::manhattan};
  EXPECT_TRUE(graph_search(square, query, manhattan).optimal);
  query.direct = {0};
  EXPECT_FALSE(graph_search(square, query, manhattan).optimal) << "one slanting leg is enough";
}

TEST(GraphMethod, OctileIsAdmissibleOnEightNeighbours) {
  const Roadmap map = test::lattice(12);
  const auto query = between(map, 0, 12 * 7 + 11);
  const auto octile = graph_search(map, query, {GraphAlgorithm::astar, GraphHeuristic::octile});
  EXPECT_TRUE(octile.optimal);
  EXPECT_EQ(octile.path.length, graph_search(map, query, GraphAlgorithm::dijkstra).path.length);
  EXPECT_LE(octile.expanded, graph_search(map, query).expanded) << "the estimate is exact there";
  EXPECT_FALSE(graph_search(map, query, {GraphAlgorithm::astar, GraphHeuristic::manhattan}).optimal);
}

TEST(GraphMethod, BreadthFirstCountsLegsNotLengths) {
  // One detour of two long legs, or three short ones.
  const Roadmap map({{0, 0}, {5, 9}, {1, 0}, {2, 0}, {3, 0}}, Edges{{0, 1}, {1, 4}, {0, 2}, {2, 3}, {3, 4}});
  const auto result = graph_search(map, between(map, 0, 4), GraphAlgorithm::bfs);
  EXPECT_EQ(result.path.points, (std::vector<Point>{{0, 0}, {5, 9}, {3, 0}}));
  EXPECT_FALSE(result.optimal);
}

TEST(GraphMethod, DepthFirstFollowsTheFirstLeg) {
  const Roadmap map = test::lattice(3);
  const auto result = graph_search(map, between(map, 0, 8), GraphAlgorithm::dfs);
  EXPECT_EQ(result.path.points,
            (std::vector<Point>{{0, 0}, {1, 0}, {2, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}, {2, 1}, {2, 2}}));
}

TEST(GraphMethod, GreedyRunsIntoTheDeadEnd) {
  // The goal is behind a wall: straight at it ends at 2, back and round by 3 and 4.
  const Roadmap map({{0, 0}, {1, 0}, {2, 0}, {0, 2}, {4, 2}, {4, 0}}, Edges{{0, 1}, {1, 2}, {0, 3}, {3, 4}, {4, 5}});
  const auto result = graph_search(map, between(map, 0, 5), GraphAlgorithm::greedy);
  EXPECT_EQ(result.status, SearchStatus::found);
  EXPECT_EQ(result.expanded, 7u) << "the start, 0, 1 and 2 first, then 3, 4 and 5";
  EXPECT_FALSE(result.optimal);
}

TEST(GraphMethod, StopsAtALimit) {
  const Roadmap map = test::lattice(30);
  for (const GraphMethod method : all_methods()) {
    const auto result = graph_search(map, between(map, 0, 899), method, {.expansions = 5});
    EXPECT_EQ(result.status, SearchStatus::stopped) << name(method);
    EXPECT_EQ(result.expanded, 5u) << name(method);
  }
}

TEST(GraphMethod, HasANameThatNamesIt) {
  for (const GraphAlgorithm a : {GraphAlgorithm::astar, GraphAlgorithm::dijkstra, GraphAlgorithm::bfs,
                                 GraphAlgorithm::dfs, GraphAlgorithm::greedy})
    EXPECT_EQ(graph_algorithm_named(name(a)), a);
  for (const GraphHeuristic h : kHeuristics) EXPECT_EQ(graph_heuristic_named(name(h)), h);
  EXPECT_FALSE(graph_algorithm_named("magic"));
  EXPECT_EQ(name(GraphMethod{GraphAlgorithm::greedy, GraphHeuristic::octile}), "greedy with octile");
  EXPECT_EQ(name(GraphMethod{GraphAlgorithm::bfs}), "bfs");
}

/// Is every leg of the path one of the query's graph? Several vertices may lie at a point.
bool is_path_of(const Roadmap& map, const GraphQuery& query, const std::vector<Point>& points) {
  std::vector<std::pair<Point, Point>> legs;
  const auto add = [&](Point p, Point q) { legs.insert(legs.end(), {{p, q}, {q, p}}); };
  for (Vertex v = 0; v < map.vertex_count(); ++v)
    for (const Vertex w : map.neighbours(v)) add(map.point(v), map.point(w));
  for (const Vertex v : query.start.vertices) add(query.start.point, map.point(v));
  for (const Terminal& goal : query.goals)
    for (const Vertex v : goal.vertices) add(goal.point, map.point(v));
  for (const std::size_t i : query.direct) add(query.start.point, query.goals[i].point);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (std::find(legs.begin(), legs.end(), std::pair(points[i], points[i + 1])) == legs.end()) return false;
  return true;
}

std::optional<Length> least(const Roadmap& map, const GraphQuery& query) {
  const auto lengths = test::bellman_ford(map, query);
  std::optional<Length> best;
  for (std::size_t i = map.vertex_count(); i < lengths.size(); ++i)
    if (lengths[i] && (!best || *lengths[i] < *best)) best = lengths[i];
  return best;
}

/// From a vertex instead of the query's start.
std::optional<Length> least_from(const Roadmap& map, GraphQuery query, Vertex v) {
  query.start = {map.point(v), {v}};
  query.direct.clear();
  return least(map, query);
}

RC_GTEST_PROP(GraphMethod, FindsAPathWhereThereIsOneAndClaimsNoMoreThanIsTrue, ()) {
  const test::GraphCase c = test::any_graph_case();
  const auto expected = least(c.map, c.query);
  for (const GraphMethod method : all_methods()) {
    RC_LOG() << name(method) << '\n';
    const auto result = graph_search(c.map, c.query, method);
    RC_ASSERT((result.status == SearchStatus::found) == expected.has_value());
    if (!expected) continue;
    RC_ASSERT(is_path_of(c.map, c.query, result.path.points));
    RC_ASSERT(result.path.points.front() == c.query.start.point);
    RC_ASSERT(result.path.points.back() == c.query.goals[result.goal].point);
    RC_ASSERT(Length(result.path.points) == result.path.length);
    RC_ASSERT(!result.optimal || result.path.length == *expected);
    RC_ASSERT(!(result.optimal && result.overestimate));
    RC_ASSERT(!optimal_everywhere(method) || result.optimal);
  }
}

double manhattan(Point p, Point q) { return std::abs(p.x - q.x) + std::abs(p.y - q.y); }

/// The witness is one, and what is called consistent overestimates nowhere: by exact costs from every vertex.
RC_GTEST_PROP(HeuristicVerdict, IsTrueOfManhattan, ()) {
  test::GraphCase c = test::any_graph_case();
  if (c.query.goals.empty()) c.query.goals.push_back({c.map.point(0), {0}});
  const GraphHeuristicVerdict verdict = heuristic_verdict(c.map, c.query, GraphHeuristic::manhattan);
  RC_ASSERT(!(verdict.consistent && verdict.overestimate));
  const auto estimate = [&](Point p) {
    double nearest = HUGE_VAL;
    for (const Terminal& goal : c.query.goals) nearest = std::min(nearest, manhattan(p, goal.point));
    return nearest;
  };
  double excess = 0;  // the largest, by far
  const auto look_at = [&](Point p, const std::optional<Length>& cost) {
    if (cost) excess = std::max(excess, (estimate(p) - cost->value()) / estimate(p));
  };
  look_at(c.query.start.point, least(c.map, c.query));
  for (Vertex v = 0; v < c.map.vertex_count(); ++v) look_at(c.map.point(v), least_from(c.map, c.query, v));
  if (verdict.consistent) RC_ASSERT(excess < 1e-12);
  RC_ASSERT(verdict.overestimate.has_value() == (excess > 1e-12));
  if (!verdict.overestimate) return;
  RC_ASSERT(verdict.overestimate->estimate > verdict.overestimate->cost);
  RC_ASSERT(verdict.overestimate->estimate == estimate(verdict.overestimate->at));
}

}  // namespace
}  // namespace taut
