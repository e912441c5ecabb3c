// Worlds as judges of certificates read them.
#include <gtest/gtest.h>

#include <taut/io/worlds/write_world.h>

#include "support/small_world.h"

namespace taut {
namespace {

using test::box_ring;

TEST(WriteIntegers, WritesWallsAreasAndSolidsOverOneUnit) {
  WorldParts parts =
      test::SmallWorld{.walls = {{{0.5, 0}, {0.5, 2}}}, .solids = {box_ring(1, 1, 2, 2)}, .area = box_ring(0, 0, 4, 3)}
          .parts();
  parts.solids[0].polygon.holes = {{{1.2, 1.2}, {1.2, 1.8}, {1.8, 1.8}, {1.8, 1.2}}};
  parts.start = Point{0.25, 1};
  parts.goal.room = {{{3, 2}, {4, 3}}};
  EXPECT_EQ(write_integers(World(parts)),
            "taut integers 1\nunit 1/10\nboundary limit\narea 0 0 40 0 40 30 0 30\nsolid 10 10 20 10 20 20 10 20\n"
            "hole 12 12 12 18 18 18 18 12\nwall 5 0 5 20\nstart 0.25 1\ngoal 3 2 4 3\n");
}

TEST(WriteIntegers, JoinsWallsOfOneLineThatTouchOrOverlap) {
  const test::SmallWorld world{
      .walls = {{{1, 1}, {2, 2}}, {{4, 4}, {2, 2}}, {{5, 5}, {6, 6}}, {{1, 2}, {2, 3}}, {{3, 3}, {2, 2}}},
      .area = box_ring(0, 0, 8, 8)};
  EXPECT_EQ(
      write_integers(World(world.parts())),
      "taut integers 1\nunit 1\nboundary limit\narea 0 0 8 0 8 8 0 8\nwall 1 1 4 4\nwall 5 5 6 6\nwall 1 2 2 3\n");
}

TEST(WriteIntegers, WritesThickWallsAsTheFreeSpaceTheyLeave) {
  const test::SmallWorld world{.walls = {{{2, 1}, {2, 3}}}, .area = box_ring(0, 0, 4, 4), .thickness = 1};
  EXPECT_EQ(write_integers(World(world.parts())),
            "taut integers 1\nunit 1/2\nboundary walled\narea 0 0 8 0 8 8 0 8\nhole 3 1 3 7 5 7 5 1\n");
}

}  // namespace
}  // namespace taut
