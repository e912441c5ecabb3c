#include <taut/roadmaps/visibility_rows.h>

#include <vector>

#include <gtest/gtest.h>

#include <taut/roadmaps/visibility_graph.h>

#include "support/random_world.h"

namespace taut {
namespace {

using test::box_ring;
using test::SmallWorld;

TEST(VisibilityRows, FindEachEdgeOnceFromItsLeftEnd) {
  const SmallWorld world{.walls = {{{3, 1}, {3, 7}}}, .solids = {box_ring(5, 2, 7, 4)}};
  const VisibilityRows rows(world.space(), VisibilityKind::full);
  const Roadmap graph = VisibilityGraph(world.space(), VisibilityKind::full).roadmap();
  VisibilityRows::Finder finder(rows);
  std::size_t edges = 0;
  for (Roadmap::Vertex u = 0; u < graph.vertex_count(); ++u)
    for (const Roadmap::Vertex v : finder.row(u)) {
      EXPECT_LT(graph.point(u), graph.point(v));
      EXPECT_TRUE(graph.adjacent(u, v));
      ++edges;
    }
  EXPECT_EQ(edges, graph.edge_count());
}

/// A line that touches blocks below and above it in turn.
SmallWorld slalom(bool on_lattice) {
  const double bit = on_lattice ? 0 : 0x1p-45;  // with it the corners are no multiples of one unit below 2^29
  return {.walls = {{{0.5, 9 + bit}, {9.5, 9 + bit}}},
          .solids = {box_ring(1, 3, 2, 5), box_ring(3, 5, 4, 7), box_ring(5, 3, 6, 5), box_ring(7, 5, 8, 7)}};
}

TEST(VisibilityRows, FollowALineThatPassesObstaclesOnBothSides) {
  for (const bool on_lattice : {true, false}) {
    const FreeSpace space = slalom(on_lattice).space();
    ASSERT_EQ(space.triangulation().lattice.empty(), !on_lattice);
    for (const VisibilityKind kind : {VisibilityKind::full, VisibilityKind::reduced})
      EXPECT_TRUE(VisibilityGraph(space, kind).roadmap() == visibility_graph_brute_force(space, kind)) << on_lattice;
  }
}

}  // namespace
}  // namespace taut
