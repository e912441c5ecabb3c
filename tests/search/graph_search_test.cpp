#include <taut/search/graph_search.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <chrono>
#include <random>

#include "support/bellman_ford.h"
#include "support/lattice.h"

namespace taut {
namespace {

using Vertex = Roadmap::Vertex;
using Edges = std::vector<std::pair<Vertex, Vertex>>;

constexpr GraphAlgorithm kBoth[] = {GraphAlgorithm::astar, GraphAlgorithm::dijkstra};

GraphQuery between(const Roadmap& map, Vertex from, Vertex to) {
  return {.start = {map.point(from), {from}}, .goals = {{map.point(to), {to}}}, .direct = {}};
}

//   2 --- 3
//   |     |      start at 0, goal at 3: up first, or right first, or over the diagonal
//   0 --- 1
const Roadmap& square() {
  static const Roadmap map({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, Edges{{0, 1}, {0, 2}, {1, 3}, {2, 3}});
  return map;
}

TEST(GraphSearch, GoesRoundTheSquare) {
  for (const auto algorithm : kBoth) {
    const auto result = graph_search(square(), between(square(), 0, 3), algorithm);
    EXPECT_EQ(result.status, SearchStatus::found);
    EXPECT_EQ(result.path.points, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}})) << "the tie goes to the smaller index";
    EXPECT_EQ(result.path.length.value(), 2);
    EXPECT_LE(result.expanded, result.generated);
  }
}

TEST(GraphSearch, TakesTheStraightLegWhenThereIsOne) {
  auto query = between(square(), 0, 3);
  query.direct = {0};
  for (const auto algorithm : kBoth) {
    const auto result = graph_search(square(), query, algorithm);
    EXPECT_EQ(result.path.points, (std::vector<Point>{{0, 0}, {1, 1}}));
    EXPECT_EQ(result.path.length.decimals(6), "1.414214");
  }
}

TEST(GraphSearch, IsOnePointWhenTheStartIsTheGoal) {
  for (const auto algorithm : kBoth) {
    const auto on_vertex = graph_search(square(), between(square(), 1, 1), algorithm);
    EXPECT_EQ(on_vertex.status, SearchStatus::found);
    EXPECT_EQ(on_vertex.path.points, (std::vector<Point>{{1, 0}}));
    const GraphQuery anywhere{.start = {{0.5, 0.5}, {}}, .goals = {{{0.5, 0.5}, {}}}, .direct = {0}};
    const auto off_graph = graph_search(Roadmap(), anywhere, algorithm);
    EXPECT_EQ(off_graph.status, SearchStatus::found);
    EXPECT_EQ(off_graph.path.points, (std::vector<Point>{{0.5, 0.5}}));
    EXPECT_EQ(off_graph.path.length.value(), 0);
  }
}

TEST(GraphSearch, FindsNoneWhereTheGraphIsCut) {
  const Roadmap map({{0, 0}, {1, 0}, {5, 0}, {6, 0}}, Edges{{0, 1}, {2, 3}});
  for (const auto algorithm : kBoth) {
    const auto result = graph_search(map, between(map, 0, 3), algorithm);
    EXPECT_EQ(result.status, SearchStatus::none);
    EXPECT_EQ(result.expanded, 3u) << "the start and the two it reaches";
    EXPECT_TRUE(result.path.points.empty());
    EXPECT_EQ(graph_search(map, {.start = {{0, 0}, {0}}, .goals = {}, .direct = {}}, algorithm).status,
              SearchStatus::none);
  }
}

TEST(GraphSearch, EndsInTheNearestGoal) {
  const Roadmap map = test::lattice(20);
  GraphQuery query{.start = {map.point(0), {0}}, .goals = {}, .direct = {}};
  for (const Vertex v : {399u, 21u * 6, 19u}) query.goals.push_back({map.point(v), {v}});
  for (const auto algorithm : kBoth) {
    const auto result = graph_search(map, query, algorithm);
    EXPECT_EQ(result.goal, 1u);
    EXPECT_EQ(result.path.length.decimals(6), "8.485281");
  }
}

TEST(GraphSearch, PrefersTheFirstOfGoalsEquallyFar) {
  const Roadmap map = test::lattice(9);
  const Vertex centre = 4 * 9 + 4;
  GraphQuery query{.start = {map.point(centre), {centre}}, .goals = {}, .direct = {}};
  for (const Vertex v : {centre + 18u + 1u, centre - 18u + 1u, centre + 9u + 2u})
    query.goals.push_back({map.point(v), {v}});
  for (const auto algorithm : kBoth) EXPECT_EQ(graph_search(map, query, algorithm).goal, 0u);
}

TEST(GraphSearch, StopsAtALimitAndSaysSo) {
  const Roadmap map = test::lattice(60);
  for (const auto algorithm : kBoth) {
    const auto counted = graph_search(map, between(map, 0, 3599), algorithm, {.expansions = 10});
    EXPECT_EQ(counted.status, SearchStatus::stopped);
    EXPECT_EQ(counted.expanded, 10u);
    EXPECT_EQ(graph_search(map, between(map, 0, 3599), algorithm, {.expansions = 0}).expanded, 0u);
    EXPECT_EQ(graph_search(map, between(map, 0, 3599), algorithm, {.seconds = 0}).status, SearchStatus::stopped);
    const auto whole = graph_search(map, between(map, 0, 3599), algorithm);
    const auto enough = graph_search(map, between(map, 0, 3599), algorithm, {.expansions = whole.expanded});
    EXPECT_EQ(enough.status, SearchStatus::found);
  }
}

TEST(GraphSearch, ReturnsTheBestSoFarWhenStopped) {
  auto query = between(square(), 0, 3);
  query.direct = {0};
  const auto result = graph_search(square(), query, GraphAlgorithm::astar, {.expansions = 1});
  EXPECT_EQ(result.path.points.size(), 2u);
}

TEST(GraphSearch, ExpandsFewerVerticesWithAHeuristic) {
  const Roadmap map = test::lattice(60);
  const auto query = between(map, 60 * 30 + 5, 60 * 30 + 55);
  const auto astar = graph_search(map, query, GraphAlgorithm::astar);
  const auto dijkstra = graph_search(map, query, GraphAlgorithm::dijkstra);
  EXPECT_EQ(astar.path.length, dijkstra.path.length);
  EXPECT_LT(astar.expanded * 10, dijkstra.expanded);
}

TEST(GraphSearch, MergesVerticesAtOnePoint) {
  // 1 and 2 are two sides of a wall end; so are start and 0.
  const Roadmap map({{0, 0}, {2, 1}, {2, 1}, {4, 0}}, Edges{{0, 1}, {1, 2}, {2, 3}});
  for (const auto algorithm : kBoth) {
    const auto result = graph_search(map, between(map, 0, 3), algorithm);
    EXPECT_EQ(result.path.points, (std::vector<Point>{{0, 0}, {2, 1}, {4, 0}}));
    EXPECT_EQ(result.path.length.terms(), 2u);
  }
}

TEST(GraphSearch, SeesADifferenceBelowTheRoundingOfTheLength) {
  // Far out, two ways round a needle differ by 2^-60, and the whole is 2^20 long.
  const double far = 0x1p20, thin = 0x1p-40;
  const Roadmap map({{0, 0}, {far, 0}, {far + 1, thin}, {far + 1, -1.5 * thin}, {far + 2, 0}},
                    Edges{{0, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 4}});
  const Roadmap flipped({{0, 0}, {far, 0}, {far + 1, 1.5 * thin}, {far + 1, -thin}, {far + 2, 0}},
                        Edges{{0, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 4}});
  for (const auto algorithm : kBoth) {
    EXPECT_EQ(graph_search(map, between(map, 0, 4), algorithm).path.points[2].y, thin);
    EXPECT_EQ(graph_search(flipped, between(flipped, 0, 4), algorithm).path.points[2].y, -thin);
  }
}

TEST(GraphSearch, OpensAgainWhatRoundingClosedTooEarly) {
  // Legs far shorter than an ulp of what lies behind them: bounds cannot order their ends, so a vertex may be expanded
  // by the longer way first.
  const double far = 0x1p40, tiny = 0x1p-30;
  std::mt19937_64 draw(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<Point> points{{-far, 0}};
    for (int i = 0; i < 8; ++i) {
      const double x = static_cast<double>(draw() % 5) * tiny, y = static_cast<double>(draw() % 5) * tiny;
      points.push_back({x, y});
    }
    Edges edges;
    for (Vertex v = 1; v <= 8; ++v) {
      if (draw() % 3 == 0) edges.emplace_back(0, v);
      for (Vertex w = 1; w < v; ++w)
        if (draw() % 3 == 0) edges.emplace_back(w, v);
    }
    const Roadmap map(points, edges);
    const auto query = between(map, 0, 8);
    const auto expected = test::bellman_ford(map, query).back();
    for (const auto algorithm : kBoth) {
      const auto result = graph_search(map, query, algorithm);
      ASSERT_EQ(result.status == SearchStatus::found, expected.has_value());
      ASSERT_EQ(result.path.length, expected.value_or(Length()));
    }
  }
}

TEST(GraphShortestPaths, KeepsTheTreeForManyGoals) {
  const auto map = std::make_shared<Roadmap>(test::lattice(30));
  const GraphShortestPaths paths(map, {map->point(0), {0}});
  EXPECT_EQ(paths.predecessor(0), GraphShortestPaths::kNoVertex);
  EXPECT_EQ(paths.predecessor(1), 0u);
  for (Vertex v = 0; v < map->vertex_count(); v += 7) {
    const auto path = paths.path_to({map->point(v), {v}}, false);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->length, graph_search(*map, between(*map, 0, v)).path.length);
  }
  EXPECT_FALSE(paths.path_to({{1, 1}, {}}, false));
  EXPECT_EQ(paths.path_to({{30, 40}, {}}, true)->length.value(), 50);
}

TEST(GraphSearch, IsTheSameEveryTime) {
  const Roadmap map = test::lattice(40);
  const auto first = graph_search(map, between(map, 3, 1590));
  for (int i = 0; i < 3; ++i) {
    const auto again = graph_search(map, between(map, 3, 1590));
    EXPECT_EQ(again.path.points, first.path.points);
    EXPECT_EQ(again.expanded, first.expanded);
    EXPECT_EQ(again.generated, first.generated);
  }
}

TEST(GraphSearch, DecidesAHugeLatticeOfTiesInTime) {
  const Roadmap map = test::lattice(400);
  const auto begin = std::chrono::steady_clock::now();
  for (const auto algorithm : kBoth) {
    const auto result = graph_search(map, between(map, 0, 399 * 400 + 200), algorithm);
    EXPECT_EQ(result.path.length.decimals(6), "481.842712");  // 200 sqrt(2) + 199
  }
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 20);
}

}  // namespace
}  // namespace taut
