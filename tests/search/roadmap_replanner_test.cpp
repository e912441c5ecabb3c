#include <taut/search/roadmap_replanner.h>

#include <map>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/graph_search.h>

#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using Vertex = Roadmap::Vertex;
using Edges = std::vector<std::pair<Vertex, Vertex>>;

/// a - b - d above, a - c - d below; below is longer.
std::shared_ptr<const Roadmap> diamond() {
  const Edges edges{{0, 1}, {1, 3}, {0, 2}, {2, 3}};
  return std::make_shared<const Roadmap>(std::vector<Point>{{0, 0}, {1, 1}, {1, -2}, {2, 0}}, edges);
}

TEST(RoadmapReplanner, TakesTheOtherWayWhenALegIsBlocked) {
  RoadmapReplanner search(diamond(), 0, 3);
  ASSERT_EQ(search.replan(), SearchStatus::found);
  EXPECT_EQ(search.path()->points[1], (Point{1, 1}));
  search.block(1, 3);
  ASSERT_EQ(search.replan(), SearchStatus::found);
  EXPECT_EQ(search.path()->points[1], (Point{1, -2}));
  search.block(0, 2);
  EXPECT_EQ(search.replan(), SearchStatus::none);
  EXPECT_FALSE(search.path());
  search.unblock(1, 3);
  ASSERT_EQ(search.replan(), SearchStatus::found);
  EXPECT_EQ(search.path()->points[1], (Point{1, 1}));
}

TEST(RoadmapReplanner, CountsALegThatBecameDearer) {
  RoadmapReplanner search(diamond(), 0, 3);
  search.set_factor(0, 1, 3);
  ASSERT_EQ(search.replan(), SearchStatus::found);
  EXPECT_EQ(search.path()->points[1], (Point{1, -2}));  // 2 sqrt(5) < 4 sqrt(2)
  EXPECT_EQ(*search.cost(), search.path()->length);
  search.set_goal(1);
  ASSERT_EQ(search.replan(), SearchStatus::found);
  EXPECT_EQ(search.cost()->decimals(6), "4.242641");  // all three legs of length sqrt(2), counted, not the way round
}

/// The cost of every vertex from `goal`, by rounds over all legs until nothing gets shorter.
std::vector<std::optional<Length>> costs_from_scratch(
    const Roadmap& map, Vertex goal, const std::map<std::pair<Vertex, Vertex>, std::uint32_t>& factors) {
  std::vector<std::optional<Length>> best(map.vertex_count());
  best[goal] = Length{};
  for (bool changed = true; changed;) {
    changed = false;
    for (Vertex u = 0; u < map.vertex_count(); ++u)
      for (const Vertex v : map.neighbours(u)) {
        const auto factor = factors.find(std::minmax(u, v));
        const std::uint32_t times = factor == factors.end() ? 1 : factor->second;
        if (!best[u] || times == 0) continue;
        Length length = *best[u];
        for (std::uint32_t k = 0; k < times; ++k) length.add(map.point(u), map.point(v));
        if (best[v] && *best[v] <= length) continue;
        best[v] = std::move(length);
        changed = true;
      }
  }
  return best;
}

RC_GTEST_PROP(RoadmapReplanner, AgreesExactlyWithASearchFromScratch, ()) {
  // Points of a small lattice: full of ties that doubles would decide wrongly.
  std::vector<Point> points;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  Edges edges;
  for (int k = any(10, 40); k > 0; --k) {
    const int u = any(0, 15), v = any(0, 15);
    if (u != v) edges.emplace_back(u, v);
  }
  RC_PRE(!edges.empty());
  const auto map = std::make_shared<const Roadmap>(points, edges);
  std::map<std::pair<Vertex, Vertex>, std::uint32_t> factors;
  const auto vertex = [] { return static_cast<Vertex>(any(0, 15)); };
  Vertex start = vertex(), goal = vertex();
  RoadmapReplanner search(map, start, goal);
  for (int round = 0; round < 8; ++round) {
    const auto exact = costs_from_scratch(*map, goal, factors)[start];
    RC_ASSERT((search.replan() == SearchStatus::found) == exact.has_value());
    RC_ASSERT(search.cost() == exact);
    if (exact) {
      RC_ASSERT(search.path()->points.front() == map->point(start));
      RC_ASSERT(search.path()->points.back() == map->point(goal));
      RC_ASSERT(search.path()->length <= *exact);
    }
    for (int k = any(0, 5); k > 0; --k) {
      const auto& [u, v] = edges[static_cast<std::size_t>(any(0, static_cast<int>(edges.size()) - 1))];
      const int kind = any(0, 3);
      if (kind == 0) {
        const auto factor = static_cast<std::uint32_t>(any(1, 3));
        factors[std::minmax(u, v)] = factor;
        search.unblock(u, v);
        search.set_factor(u, v, factor);
      } else if (kind < 3) {
        factors[std::minmax(u, v)] = 0;
        search.block(u, v);
      } else {
        factors[std::minmax(u, v)] = 1;
        search.unblock(u, v);
        search.set_factor(u, v, 1);
      }
    }
    if (any(0, 1)) search.move_to(start = vertex());
    if (any(0, 7) == 0) search.set_goal(goal = vertex());
  }
}

/// The legs of a map that have a length: two sides of the end of a wall are two vertices at one point.
Edges real_legs(const Roadmap& map) {
  Edges legs;
  for (Vertex u = 0; u < map.vertex_count(); ++u)
    for (const Vertex v : map.neighbours(u))
      if (u < v && map.point(u) != map.point(v)) legs.emplace_back(u, v);
  return legs;
}

RC_GTEST_PROP(RoadmapReplanner, AgreesWithGraphSearchOnVisibilityGraphsWithBlockedLegs, ()) {
  const FreeSpace space = test::any_world({.side = 8, .walls = 14}).space();
  const VisibilityGraph graph(space, any(0, 1) ? VisibilityKind::reduced : VisibilityKind::full);
  const auto points = graph.roadmap().points();
  const Edges legs = real_legs(graph.roadmap());
  RC_PRE(!legs.empty());
  const auto map = std::make_shared<const Roadmap>(std::vector<Point>(points.begin(), points.end()), legs);
  const auto vertex = [&] { return static_cast<Vertex>(any(0, static_cast<int>(map->vertex_count()) - 1)); };
  std::vector<bool> blocked(legs.size());
  Vertex start = vertex();
  const Vertex goal = vertex();
  RoadmapReplanner search(map, start, goal);
  for (int round = 0; round < 6; ++round) {
    Edges left;
    for (std::size_t i = 0; i < legs.size(); ++i)
      if (!blocked[i]) left.push_back(legs[i]);
    const Roadmap now(std::vector<Point>(points.begin(), points.end()), left);
    const GraphQuery query{{now.point(start), {start}}, {{now.point(goal), {goal}}}, {}};
    const GraphSearchResult exact = graph_search(now, query);
    RC_ASSERT(search.replan() == exact.status);
    if (exact.status == SearchStatus::found) {
      RC_ASSERT(*search.cost() == exact.path.length);
      RC_ASSERT(search.path()->length == exact.path.length);
    }
    for (int k = any(0, 8); k > 0; --k) {
      const auto i = static_cast<std::size_t>(any(0, static_cast<int>(legs.size()) - 1));
      blocked[i] = !blocked[i];
      blocked[i] ? search.block(legs[i].first, legs[i].second) : search.unblock(legs[i].first, legs[i].second);
    }
    if (any(0, 1)) search.move_to(start = vertex());
  }
}

}  // namespace
}  // namespace taut
