#include <taut/search/graph_search.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "support/bellman_ford.h"
#include "support/graph_case.h"

namespace taut {
namespace {

using test::bellman_ford;
using test::plus_leg;
using Vertex = Roadmap::Vertex;

constexpr GraphAlgorithm kBoth[] = {GraphAlgorithm::astar, GraphAlgorithm::dijkstra};

RC_GTEST_PROP(GraphSearch, AgreesWithBellmanFord, ()) {
  const test::GraphCase c = test::any_graph_case();
  const auto lengths = bellman_ford(c.map, c.query);
  std::optional<Length> expected;
  for (std::size_t i = c.map.vertex_count(); i < lengths.size(); ++i)
    if (lengths[i] && (!expected || *lengths[i] < *expected)) expected = lengths[i];
  for (const auto algorithm : kBoth) {
    const auto result = graph_search(c.map, c.query, algorithm);
    RC_ASSERT((result.status == SearchStatus::found) == expected.has_value());
    if (!expected) continue;
    RC_ASSERT(result.path.length == *expected);
    RC_ASSERT(Length(result.path.points) == *expected);
    RC_ASSERT(result.path.points.front() == c.query.start.point);
    RC_ASSERT(result.path.points.back() == c.query.goals[result.goal].point);
    RC_ASSERT(*lengths[c.map.vertex_count() + result.goal] == *expected);
    RC_ASSERT(std::adjacent_find(result.path.points.begin(), result.path.points.end()) == result.path.points.end());
  }
}

RC_GTEST_PROP(GraphShortestPaths, AgreesWithBellmanFordOnEveryGoal, ()) {
  const test::GraphCase c = test::any_graph_case();
  const auto lengths = bellman_ford(c.map, c.query);
  const GraphShortestPaths paths(std::make_shared<Roadmap>(c.map), c.query.start);
  for (std::size_t i = 0; i < c.query.goals.size(); ++i) {
    const bool direct = std::find(c.query.direct.begin(), c.query.direct.end(), i) != c.query.direct.end();
    const auto path = paths.path_to(c.query.goals[i], direct);
    const auto& expected = lengths[c.map.vertex_count() + i];
    RC_ASSERT(path.has_value() == expected.has_value());
    if (path) RC_ASSERT(path->length == *expected && Length(path->points) == *expected);
  }
  for (Vertex v = 0; v < c.map.vertex_count(); ++v) {
    RC_ASSERT(paths.reached(v) == lengths[v].has_value());
    const Vertex before = paths.predecessor(v);
    if (before != GraphShortestPaths::kNoVertex)
      RC_ASSERT(plus_leg(*lengths[before], c.map.point(before), c.map.point(v)) == *lengths[v]);
  }
}

}  // namespace
}  // namespace taut
