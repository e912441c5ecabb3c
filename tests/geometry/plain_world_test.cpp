// Worlds without thickness, overlaps and footprints.
#include <taut/geometry/plain_world.h>

#include <gtest/gtest.h>

#include <taut/search/shortest_path.h>

#include "support/small_world.h"

namespace taut {
namespace {

using test::box_ring;

TEST(PlainWorld, IsTheWorldItselfWhereItIsPlain) {
  const FreeSpace space = test::SmallWorld{.walls = {{{1, 1}, {4, 4}}}, .solids = {box_ring(6, 6, 8, 8)}}.space();
  EXPECT_TRUE(is_plain(space.world()));
  const World plain = plain_world(space);
  EXPECT_EQ(plain.walls().size(), 1U);
  EXPECT_EQ(plain.solids().size(), 1U);
}

TEST(PlainWorld, HasOneAreaForRoomsThatShareADoor) {
  WorldParts parts = test::SmallWorld{.area = box_ring(0, 0, 4, 4)}.parts();
  parts.boundary = Boundary::walled;
  parts.areas.push_back({{box_ring(4, 1, 8, 2), {}}, 0});
  const FreeSpace space{World(parts)};
  EXPECT_FALSE(is_plain(space.world()));
  EXPECT_EQ(plain_world(space).areas().size(), 1U);
}

TEST(PlainWorld, KeepsAPointsWayAsLongAsItIsAmongThickWallsAndForASquare) {
  const Point from{1, 1}, to{9, 1};
  const test::SmallWorld thick{.walls = {{{5, 0}, {5, 7}}, {{2, 10}, {2, 4}}}, .thickness = 0.5};
  const test::SmallWorld thin{.walls = thick.walls};
  for (const FreeSpace& space : {thick.space(), FreeSpace(World(thin.parts()), Footprint::square(0.25))}) {
    const World plain = plain_world(space);
    EXPECT_TRUE(plain.walls().empty());
    EXPECT_EQ(shortest_path(space, from, to)->length, shortest_path(FreeSpace(plain), from, to)->length);
  }
}

}  // namespace
}  // namespace taut
