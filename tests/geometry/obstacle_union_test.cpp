#include <gtest/gtest.h>

#include <cmath>

#include <taut/geometry/detail/obstacle_union.h>
#include <taut/geometry/detail/obstacles.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/predicates.h>
#include <taut/geometry/written.h>
#include "support/messy_world.h"
#include "support/polygon_set.h"

namespace taut {
namespace {

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

constexpr Box kWhole{{-100, -100}, {100, 100}};

std::vector<detail::Edge> outline(std::vector<Ring> rings) {
  std::vector<detail::ConvexPiece> pieces;
  for (Ring& ring : rings) pieces.push_back({std::move(ring), kNone});
  return detail::outline_of_union(pieces, kWhole).edges;
}

TEST(OutlineOfUnion, HasNoSeamBetweenAdjacentBlocks) {
  EXPECT_EQ(outline({box(0, 0, 1, 1), box(1, 0, 2, 1)}).size(), 4u);
}

TEST(OutlineOfUnion, CountsASharedSideOnce) {
  EXPECT_EQ(outline({box(0, 0, 2, 1), box(0, 0, 1, 1), box(0, 0, 2, 1)}).size(), 4u);
}

TEST(OutlineOfUnion, KeepsTheHoleOfAFrame) {
  EXPECT_EQ(outline({box(0, 0, 3, 1), box(0, 2, 3, 3), box(0, 0, 1, 3), box(2, 0, 3, 3)}).size(), 8u);
}

TEST(OutlineOfUnion, KeepsBothBlocksThatTouchInAPoint) {
  EXPECT_EQ(outline({box(0, 0, 1, 1), box(1, 1, 2, 2)}).size(), 8u);
}

TEST(OutlineOfUnion, RoundsCrossingsToTheFreeSide) {
  const std::vector<Ring> rings = {{{0, 0}, {3, 1}, {0, 1}}, {{1, -1}, {2, 2}, {0.7, 2}}};
  for (const detail::Edge& e : outline(rings))
    for (const Ring& ring : rings) EXPECT_LE(written::side_of_ring(e.a, ring), 0) << e.a.x << ' ' << e.a.y;
}

TEST(FreeSpacePolygons, NeverClaimWhatCgalCallsSolidAndMissAlmostNothing) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const test::MessyWorld messy = test::messy_world(seed);
    const World world(messy.parts);
    const FreeSpace space(world, messy.footprint);
    const auto opinion =
        test::opinion_of_cgal(detail::obstacles_of(world, messy.footprint).pieces, world.box(), space.polygons());
    // CGAL takes doubles as they are; here they mean decimals of 15 digits.
    EXPECT_NEAR(opinion.stolen_area, 0, 1e-15) << "seed " << seed;
    EXPECT_NEAR(opinion.claimed_area, opinion.free_area, 1e-11) << "seed " << seed;
    EXPECT_LE(space.report().displacement, 1e-11) << "seed " << seed;
  }
}

TEST(Obstacles, CoverATiltedWallWhollyAndLittleMore) {
  // A 3-4-5 wall has corners with exact doubles: what is added on all sides is seen.
  WorldParts parts;
  parts.areas.push_back({Polygon{box(-10, -10, 10, 10), {}}, 0});
  parts.walls.push_back({{0, 0}, {3, 4}, 2, 0});
  const World world(parts);
  const auto obstacles = detail::obstacles_of(world, Footprint::point());
  const Ring& ring = obstacles.pieces[0].ring;
  for (const Point corner : {Point{-0.6 + 0.8, -0.8 - 0.6}, Point{-0.6 - 0.8, -0.8 + 0.6}, Point{3.6 + 0.8, 4.8 - 0.6},
                             Point{3.6 - 0.8, 4.8 + 0.6}})
    EXPECT_GE(written::side_of_ring(corner, ring), 0) << corner.x << ' ' << corner.y;
  EXPECT_NEAR(ring_area(ring) / 2, 7 * 2, 1e-12);
  EXPECT_LE(obstacles.excess, 1e-12);
}

TEST(Obstacles, OfADiscCoverTheExactDiscAndAreAThousandthLarger) {
  const Ring ring = Footprint::disc(1).ring();
  ASSERT_EQ(ring.size(), static_cast<std::size_t>(Footprint::kDiscSides));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    EXPECT_GE((a.x * b.y - a.y * b.x) / std::hypot(b.x - a.x, b.y - a.y), 1 - 1e-15);
    EXPECT_LE(std::hypot(a.x, a.y), 1 + Footprint::kDiscExcess);
  }
}

}  // namespace
}  // namespace taut
