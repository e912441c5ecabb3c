#include <taut/roadmaps/roadmap.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace taut {
namespace {

using Vertex = Roadmap::Vertex;
using Edges = std::vector<std::pair<Vertex, Vertex>>;

std::vector<Vertex> row(const Roadmap& map, Vertex v) { return {map.neighbours(v).begin(), map.neighbours(v).end()}; }

TEST(Roadmap, IsEmptyWithoutPoints) {
  const Roadmap map;
  EXPECT_EQ(map.vertex_count(), 0u);
  EXPECT_EQ(map.edge_count(), 0u);
  EXPECT_EQ(map, Roadmap({}, Edges{}));
}

TEST(Roadmap, ListsEachEdgeFromBothEndsInOrder) {
  const Roadmap map({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, Edges{{3, 1}, {0, 3}, {1, 0}});
  EXPECT_EQ(map.edge_count(), 3u);
  EXPECT_EQ(row(map, 0), (std::vector<Vertex>{1, 3}));
  EXPECT_EQ(row(map, 1), (std::vector<Vertex>{0, 3}));
  EXPECT_EQ(row(map, 2), (std::vector<Vertex>{}));
  EXPECT_EQ(row(map, 3), (std::vector<Vertex>{0, 1}));
  EXPECT_EQ(map.point(2), (Point{2, 0}));
}

TEST(Roadmap, DropsLoopsAndDuplicates) {
  const Roadmap map({{0, 0}, {1, 0}}, Edges{{0, 1}, {1, 1}, {1, 0}, {0, 1}, {0, 0}});
  EXPECT_EQ(map.edge_count(), 1u);
  EXPECT_EQ(map, Roadmap({{0, 0}, {1, 0}}, std::vector<std::uint64_t>{0, 1, 2}, std::vector<Vertex>{1, 0}));
}

TEST(Roadmap, KeepsVerticesAtOnePointApart) {
  const Roadmap map({{1, 1}, {1, 1}, {2, 2}}, Edges{{0, 2}});
  EXPECT_TRUE(map.adjacent(0, 2));
  EXPECT_FALSE(map.adjacent(1, 2));
}

RC_GTEST_PROP(Roadmap, HoldsExactlyTheEdgesItWasGiven, ()) {
  const auto n = *rc::gen::inRange<Vertex>(1, 12);
  const auto edges =
      *rc::gen::container<Edges>(rc::gen::pair(rc::gen::inRange<Vertex>(0, n), rc::gen::inRange<Vertex>(0, n)));
  const Roadmap map(std::vector<Point>(n), edges);
  std::set<std::pair<Vertex, Vertex>> expected;
  for (const auto& [u, v] : edges)
    if (u != v) expected.insert({std::min(u, v), std::max(u, v)});
  RC_ASSERT(map.edge_count() == expected.size());
  for (Vertex u = 0; u < n; ++u) {
    RC_ASSERT(std::is_sorted(map.neighbours(u).begin(), map.neighbours(u).end()));
    for (Vertex v = 0; v < n; ++v) {
      RC_ASSERT(map.adjacent(u, v) == expected.contains({std::min(u, v), std::max(u, v)}));
      RC_ASSERT(map.adjacent(u, v) == map.adjacent(v, u));
    }
  }
}

}  // namespace
}  // namespace taut
