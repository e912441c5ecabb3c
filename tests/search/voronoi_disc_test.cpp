// A disc on the diagram of the walls, and on that of the polygons around it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/errors.h>
#include <taut/search/roadmap_kinds.h>
#include <taut/search/verify.h>

#include "support/random_world.h"

namespace {

using namespace taut;
using namespace taut::test;

GraphSearchResult asked(const FreeSpace& space, Point from, const Goal& to, bool with_ends) {
  BuildRequest request;
  if (with_ends) request.from = from;
  if (with_ends) request.to = to;
  return roadmap_kind("voronoi")->build(space, request).search(from, to, {});
}

RC_GTEST_PROP(VoronoiOfADisc, GetsWhereItGetsOnTheDiagramOfTheGrownWalls, ()) {
  const SmallWorld drawn = any_world({.side = 8, .walls = 5, .solids = 1});
  try {
    const FreeSpace space(drawn.bounded(any(0, 1) ? Boundary::walled : Boundary::limit), Footprint::disc(0.375));
    for (int n = 0; n < 3; ++n) {
      const Point from = any_fine_point(8), to = any_fine_point(8);
      if (!space.holds(from) || !space.holds(to)) continue;
      const GraphSearchResult grown = asked(space, from, {to, {}}, false), bare = asked(space, from, {to, {}}, true);
      if (bare.status != grown.status) RC_FAIL(show(drawn) + " " + show(from) + show(to));
      if (bare.status != SearchStatus::found) continue;
      const Verdict verdict = verify(bare.path, space, from, {to, {}});
      if (!verdict.valid) RC_FAIL(show(drawn) + " " + show(from) + show(to) + verdict.reason);
    }
  } catch (const InputError&) {  // walls meet too sharply
  }
}

TEST(VoronoiOfADisc, KeepsOnlyWhatLeavesItRoom) {
  const SmallWorld world{{{{5, 0}, {5, 4.75}}, {{5, 5.25}, {5, 10}}}};
  const FreeSpace space(world.bounded(Boundary::walled), Footprint::disc(0.5));
  BuildRequest request;
  request.from = Point{2, 5};
  request.to.point = Point{8, 5};
  const PlannedRoadmap planned = roadmap_kind("voronoi")->build(space, request);
  EXPECT_EQ(planned.search({2, 5}, request.to, {}).status, SearchStatus::none);
  const Roadmap& map = *planned.roadmap;
  EXPECT_GT(map.edge_count(), 0U);
  for (Roadmap::Vertex v = 0; v < map.vertex_count(); ++v)
    for (const Roadmap::Vertex w : map.neighbours(v)) EXPECT_EQ(map.point(v).x < 5, map.point(w).x < 5);
}

}  // namespace
