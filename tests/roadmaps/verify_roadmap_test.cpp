#include <taut/roadmaps/verify_roadmap.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/prm.h>
#include <taut/roadmaps/visibility_graph.h>

namespace taut {
namespace {

using testing::HasSubstr;
using Edge = std::pair<Roadmap::Vertex, Roadmap::Vertex>;
using Edges = std::vector<Edge>;

// A room, and a wall from the bottom, 3 of 4 high.
constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\nstart 1 2\ngoal 3 2\n";

FreeSpace room() { return FreeSpace(read_world(kRoom, ReadOptions{.source = "room.txt"})); }

Edges edges_of(const Roadmap& roadmap) {
  Edges edges;
  for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v)
    for (const Roadmap::Vertex w : roadmap.neighbours(v))
      if (v < w) edges.emplace_back(v, w);
  return edges;
}

TEST(RoadmapCheck, AcceptsEveryPrmOfTheSpace) {
  const FreeSpace space = room();
  EXPECT_FALSE(verify_roadmap(Roadmap(), space));
  EXPECT_FALSE(verify_roadmap(prm(space), space));
}

TEST(RoadmapCheck, RefusesAnEdgeThroughAWall) {
  const auto fault = verify_roadmap(Roadmap({{1, 1}, {1, 2}, {3, 1}}, Edges{{0, 1}, {1, 2}}), room());
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->vertex, 1u);
  EXPECT_TRUE(fault->is_row);
  EXPECT_EQ(fault->text, "the edge from vertex 1, (1, 2), to vertex 2, (3, 1), leads through an obstacle");
}

TEST(RoadmapCheck, RefusesVerticesOutsideAndOnWalls) {
  for (const Point p : {Point{5, 1}, Point{2, 1}, Point{2, 3}, Point{0, 0}}) {
    const auto fault = verify_roadmap(Roadmap({{1, 1}, p}, Edges{}), room());
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->vertex, 1u);
    EXPECT_FALSE(fault->is_row);
    EXPECT_THAT(fault->text, HasSubstr("lies in an obstacle or touches one"));
  }
}

TEST(RoadmapDifference, IsNoneOfARoadmapAndItself) {
  const Roadmap graph = VisibilityGraph(room(), VisibilityKind::full).roadmap();
  EXPECT_FALSE(difference(graph, graph));
  EXPECT_FALSE(difference(Roadmap(), Roadmap()));
}

TEST(RoadmapDifference, NamesEveryEdgeThatIsMissingOrTooMany) {
  const Roadmap graph = VisibilityGraph(room(), VisibilityKind::full).roadmap();
  const Edges edges = edges_of(graph);
  ASSERT_GT(edges.size(), 5u);
  for (const Edge& gone : edges) {
    Edges rest = edges;
    rest.erase(std::find(rest.begin(), rest.end(), gone));
    const Roadmap less(graph.points(), rest);
    const auto missing = difference(less, graph), extra = difference(graph, less);
    ASSERT_TRUE(missing && extra);
    for (const auto& fault : {*missing, *extra}) {
      EXPECT_EQ(fault.vertex, gone.first);
      EXPECT_TRUE(fault.is_row);
      EXPECT_THAT(fault.text, HasSubstr("to vertex " + std::to_string(gone.second) + ","));
    }
    EXPECT_THAT(missing->text, HasSubstr("is missing"));
    EXPECT_THAT(extra->text, HasSubstr("does not belong there"));
  }
}

TEST(RoadmapDifference, NamesTheFirstVertexElsewhere) {
  const Roadmap wanted({{0, 0}, {1, 1}, {2, 2}}, Edges{{0, 1}});
  const auto moved = difference(Roadmap({{0, 0}, {1, 0}, {2, 2}}, Edges{{0, 1}}), wanted);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->vertex, 1u);
  EXPECT_EQ(moved->text, "vertex 1, (1, 0), does not belong there");
  const auto cut = difference(Roadmap({{0, 0}, {1, 1}}, Edges{{0, 1}}), wanted);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->text, "vertex 2, (2, 2), is missing");
  const auto more = difference(wanted, Roadmap({{0, 0}, {1, 1}}, Edges{{0, 1}}));
  ASSERT_TRUE(more);
  EXPECT_EQ(more->text, "vertex 2, (2, 2), does not belong there");
}

}  // namespace
}  // namespace taut
