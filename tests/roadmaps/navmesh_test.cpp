#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/geometry/predicates.h>
#include <taut/geometry/written.h>
#include <taut/roadmaps/navmesh.h>

#include "support/random_world.h"

namespace taut {
namespace {

using namespace test;

double area_of(const Navmesh& mesh) {
  double area = 0;
  for (std::uint32_t p = 0; p < mesh.polygon_count(); ++p) {
    Ring ring;
    for (const Navmesh::Corner& c : mesh.ring(p)) ring.push_back(c.point);
    area += ring_area(ring) / 2;
  }
  return area;
}

/// Are there two polygons that only this one keeps together? By leaving it out.
bool joined_without(const Navmesh& mesh, std::uint32_t from, std::uint32_t to, std::uint32_t without) {
  std::vector<bool> seen(mesh.polygon_count(), false);
  std::vector<std::uint32_t> open{from};
  seen[from] = seen[without] = true;
  while (!open.empty()) {
    const std::uint32_t p = open.back();
    open.pop_back();
    if (p == to) return true;
    for (const Navmesh::Corner& c : mesh.ring(p)) {
      if (c.across == kNone) continue;
      const std::uint32_t n = mesh.corners[c.across].polygon;
      if (!seen[n]) open.push_back(n);
      seen[n] = true;
    }
  }
  return false;
}

TEST(Navmesh, OfAnEmptyRoomIsOnePolygon) {
  const Navmesh mesh = navmesh(SmallWorld{}.space());
  EXPECT_EQ(mesh.polygon_count(), 1U);
  EXPECT_EQ(mesh.ring(0).size(), 4U);
  EXPECT_EQ(area_of(mesh), 100);
}

TEST(Navmesh, HasABendAtTheFreeEndOfAWall) {
  const Navmesh mesh = navmesh(SmallWorld{.walls = {{{5, 0}, {5, 6}}}, .solids = {}}.space());
  ASSERT_EQ(mesh.bends.size(), 1U);
  EXPECT_EQ(mesh.bends[0].right, (Point{5, 0}));
  EXPECT_EQ(mesh.corners[mesh.bends[0].right_corner].point, (Point{5, 6}));
}

TEST(Navmesh, BetweenTwoPlacesOfAPerfectMazeIsTheCorridor) {
  const FreeSpace space(world_of(std::make_shared<GridMaze>(generate_backtracker(60, 60, 1))));
  const Navmesh all = navmesh(space), near = navmesh_between(space, {0.5, 0.5}, {Point{2.5, 0.5}, {}});
  EXPECT_LT(near.polygon_count() * 2, all.polygon_count());
  for (std::uint32_t p = 0; p < near.polygon_count(); ++p) {
    const auto ring = near.ring(p);
    EXPECT_LE(std::count_if(ring.begin(), ring.end(), [](const auto& c) { return c.across != kNone; }), 2);
  }
}

RC_GTEST_PROP(Navmesh, IsConvexAndCoversTheFreeSpace, ()) {
  const FreeSpace space = any_world({.side = 8, .walls = 15, .solids = 5}).space();
  const Navmesh mesh = navmesh(space), fine = triangle_navmesh(space);
  RC_ASSERT(std::abs(area_of(mesh) - area_of(fine)) < 1e-9);
  RC_ASSERT(mesh.polygon_count() <= fine.polygon_count());
  for (std::uint32_t c = 0; c < mesh.corners.size(); ++c) {
    const std::uint32_t next = mesh.next(c), across = mesh.corners[c].across;
    RC_ASSERT(mesh.previous(next) == c);
    RC_ASSERT(written::orientation(mesh.corners[mesh.previous(c)].point, mesh.corners[c].point,
                                   mesh.corners[next].point) >= 0);
    if (across == kNone) continue;
    RC_ASSERT(mesh.corners[across].across == c);
    RC_ASSERT(mesh.corners[across].point == mesh.corners[next].point);
    RC_ASSERT(mesh.corners[across].block == mesh.corners[c].block && mesh.corners[c].block != kNone);
  }
  for (const Navmesh::Bend& bend : mesh.bends) {
    RC_ASSERT(mesh.corners[mesh.next(bend.right_corner)].point == bend.right);
    RC_ASSERT(mesh.corners[mesh.previous(bend.left_corner)].point == bend.left);
  }
}

RC_GTEST_PROP(Navmesh, BlocksMeetWhereOnePolygonKeepsThemTogether, ()) {
  const Navmesh mesh = navmesh(any_world({.side = 6, .walls = 12, .solids = 3}).space());
  for (std::uint32_t p = 0; p < mesh.polygon_count(); ++p)
    for (const Navmesh::Corner& a : mesh.ring(p))
      for (const Navmesh::Corner& b : mesh.ring(p)) {
        if (a.across == kNone || b.across == kNone) continue;
        const std::uint32_t left = mesh.corners[a.across].polygon, right = mesh.corners[b.across].polygon;
        RC_ASSERT((a.block == b.block) == (left == right || joined_without(mesh, left, right, p)));
      }
}

}  // namespace
}  // namespace taut
