#include <taut/search/verify.h>

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/small_world.h"

namespace taut {
namespace {

using test::box_ring;
using test::SmallWorld;
using testing::HasSubstr;

Path path_through(std::vector<Point> points) {
  const Length length(points);
  return {std::move(points), length};
}

Goal at(Point p) { return {p, {}}; }

Verdict check(const SmallWorld& world, std::vector<Point> points) {
  const FreeSpace space = world.space();
  const Point from = points.front(), to = points.back();
  return verify(path_through(std::move(points)), space, from, at(to));
}

const SmallWorld kOneWall{.walls = {{{5, 0}, {5, 6}}}, .solids = {}};

TEST(Verify, AcceptsAPathAroundAWall) {
  const Verdict verdict = check(kOneWall, {{1, 1}, {5, 6}, {9, 1}});
  EXPECT_TRUE(verdict.valid) << verdict.reason;
  EXPECT_EQ(verdict.reason, "");
  EXPECT_EQ(verdict.clearance, 0);
  EXPECT_NE(verdict.nearest, kNone);
}

TEST(Verify, NamesTheLegAndTheWallItCrosses) {
  const Verdict verdict = check(kOneWall, {{1, 1}, {4, 1}, {9, 1}});
  EXPECT_FALSE(verdict.valid);
  EXPECT_EQ(verdict.leg, 1u);
  EXPECT_THAT(verdict.reason, HasSubstr("leg 1, (4, 1) to (9, 1), crosses the wall (5, "));
}

TEST(Verify, RefusesALegThatMissesTheWallsEndByOneBit) {
  EXPECT_TRUE(check(kOneWall, {{1, 6}, {9, 6}}).valid);
  EXPECT_FALSE(check(kOneWall, {{1, std::nextafter(6, 0)}, {9, std::nextafter(6, 0)}}).valid);
}

TEST(Verify, RefusesTheJointOfTwoWalls) {
  const SmallWorld world{.walls = {{{2, 2}, {5, 5}}, {{5, 5}, {8, 2}}}, .solids = {}};
  const Verdict through = check(world, {{5, 1}, {5, 9}});
  EXPECT_FALSE(through.valid);
  EXPECT_THAT(through.reason, HasSubstr("slips through the joint (5, 5) of the wall"));
  EXPECT_FALSE(check(world, {{5, 1}, {5, 5}, {5, 9}}).valid);
  EXPECT_TRUE(check(world, {{1, 5}, {9, 5}}).valid);
  EXPECT_TRUE(check(world, {{1, 4}, {5, 5}, {9, 4}}).valid);
}

TEST(Verify, RefusesAPathThatChangesSidesOfTheWallItRunsAlong) {
  EXPECT_TRUE(check(kOneWall, {{4, 1}, {5, 2}, {5, 4}, {4, 5}}).valid);
  const Verdict verdict = check(kOneWall, {{4, 1}, {5, 2}, {5, 4}, {6, 5}});
  EXPECT_FALSE(verdict.valid);
  EXPECT_EQ(verdict.leg, 2u);
  EXPECT_THAT(verdict.reason, HasSubstr("passes through the wall"));
  EXPECT_TRUE(check(kOneWall, {{4, 1}, {5, 2}, {5, 6}, {5, 4}, {6, 5}}).valid) << "around the free end";
}

TEST(Verify, KnowsWhereWallsCross) {
  const SmallWorld world{.walls = {{{2, 5}, {8, 5}}, {{5, 2}, {5, 8}}}, .solids = {}};
  EXPECT_FALSE(check(world, {{3, 3}, {7, 7}}).valid);
  EXPECT_TRUE(check(world, {{3, 3}, {5, 5}, {3, 4}}).valid);
  EXPECT_TRUE(check(world, {{4, 5}, {5, 5}, {5, 4}}).valid);
  EXPECT_FALSE(check(world, {{4, 5}, {6, 5}}).valid);
}

TEST(Verify, RefusesTheCornerWhereTwoBlocksTouch) {
  const SmallWorld world{.walls = {}, .solids = {box_ring(2, 2, 5, 5), box_ring(5, 5, 8, 8)}};
  EXPECT_FALSE(check(world, {{4, 6}, {6, 4}}).valid);
  EXPECT_FALSE(check(world, {{4, 6}, {5, 5}, {6, 4}}).valid);
  EXPECT_TRUE(check(world, {{2, 5}, {5, 5}, {5, 8}}).valid);
}

TEST(Verify, RefusesTheSeamOfAdjacentBlocks) {
  const SmallWorld world{.walls = {}, .solids = {box_ring(2, 2, 5, 5), box_ring(5, 2, 8, 5)}};
  EXPECT_FALSE(check(world, {{5, 2}, {5, 5}}).valid);
  EXPECT_FALSE(check(world, {{5, 1}, {5, 9}}).valid);
  EXPECT_TRUE(check(world, {{1, 5}, {9, 5}}).valid);
}

TEST(Verify, MayRunAlongTheBoundaryButNotLeave) {
  const SmallWorld world;
  EXPECT_TRUE(check(world, {{0, 0}, {10, 0}, {10, 10}}).valid);
  EXPECT_THAT(check(world, {{5, 5}, {5, 11}}).reason, HasSubstr("crosses the outline"));
  EXPECT_FALSE(check(world, {{5, 10}, {5, 11}}).valid);
  EXPECT_THAT(check(world, {{5, 11}, {6, 11}}).reason, HasSubstr("outside the world"));
}

TEST(Verify, RefusesAStartInsideAnObstacle) {
  const SmallWorld world{.walls = {}, .solids = {box_ring(2, 2, 5, 5)}};
  EXPECT_THAT(check(world, {{3, 3}, {4, 4}}).reason, HasSubstr("inside an obstacle"));
  EXPECT_FALSE(check(world, {{2, 2}, {5, 5}}).valid);
  EXPECT_TRUE(check(world, {{2, 2}, {5, 2}}).valid);
}

TEST(Verify, TakesAPathOfOnePoint) {
  EXPECT_TRUE(check(kOneWall, {{1, 1}}).valid);
  EXPECT_TRUE(check(kOneWall, {{5, 3}}).valid);
  EXPECT_FALSE(check(kOneWall, {{5, 11}}).valid);
}

TEST(Verify, TakesRepeatedPoints) {
  EXPECT_TRUE(check(kOneWall, {{1, 1}, {1, 1}, {5, 6}, {5, 6}, {9, 1}, {9, 1}}).valid);
  EXPECT_FALSE(check(kOneWall, {{4, 3}, {5, 3}, {5, 3}, {6, 3}}).valid);
}

TEST(Verify, RefusesOtherEndsAndNoPoints) {
  const FreeSpace space = kOneWall.space();
  const Path path = path_through({{1, 1}, {2, 2}});
  EXPECT_EQ(verify(path, space, {1, 2}, at({2, 2})).reason, "the path starts at (1, 1), not at (1, 2)");
  EXPECT_EQ(verify(path, space, {1, 1}, at({2, 3})).reason, "the path ends at (2, 2), not at (2, 3)");
  EXPECT_EQ(verify(path, space, {1, 1}, Goal{}).reason, "the path ends at (2, 2), but there is no goal");
  EXPECT_EQ(verify({}, space, {1, 1}, at({2, 3})).reason, "the path has no points");
}

TEST(Verify, RefusesNumbersThatAreNoCoordinates) {
  const FreeSpace space = kOneWall.space();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, 1e300}) {
    const Path path{{{1, 1}, {bad, 1}, {2, 2}}, {}};
    const Verdict verdict = verify(path, space, {1, 1}, at({2, 2}));
    EXPECT_FALSE(verdict.valid);
    EXPECT_THAT(verdict.reason, HasSubstr("point 1, "));
  }
}

TEST(Verify, RefusesAnotherLength) {
  const FreeSpace space = kOneWall.space();
  Path path = path_through({{1, 1}, {2, 2}, {4, 4}});
  const std::vector<Point> straight{{1, 1}, {4, 4}};
  path.length = Length(straight);
  EXPECT_TRUE(verify(path, space, {1, 1}, at({4, 4})).valid) << "sqrt 2 + sqrt 8 is sqrt 18";
  const std::vector<Point> longer{{1, 1}, {4, std::nextafter(4, 5)}};
  path.length = Length(longer);
  const Verdict verdict = verify(path, space, {1, 1}, at({4, 4}));
  EXPECT_FALSE(verdict.valid);
  EXPECT_THAT(verdict.reason, HasSubstr("the claimed length"));
}

TEST(Verify, FindsTheFirstOffendingLeg) {
  const SmallWorld world{.walls = {{{2, 0}, {2, 5}}, {{4, 0}, {4, 5}}, {{4, 5}, {4, 9}}}, .solids = {}};
  EXPECT_EQ(check(world, {{1, 6}, {3, 6}, {4, 5}, {5, 5}, {1, 1}}).leg, 2u);
  EXPECT_EQ(check(world, {{1, 1}, {3, 1}, {5, 1}}).leg, 0u);
}

TEST(VerifyRoom, AcceptsAnEndOnTheRimOfTheRoom) {
  const FreeSpace space = kOneWall.space();
  const Goal room{std::nullopt, {{{6, 2}, {7, 3}}, {{7, 2}, {8, 3}}}};
  EXPECT_TRUE(verify(path_through({{9, 1}, {8, 2}}), space, {9, 1}, room).valid);
  EXPECT_THAT(verify(path_through({{9, 1}, {9, 2}}), space, {9, 1}, room).reason, HasSubstr("outside the goal room"));
}

TEST(VerifyRoom, RefusesAnEndOnTheOtherSideOfTheRoomsWall) {
  const FreeSpace space = kOneWall.space();
  const Goal room{std::nullopt, {{{5, 2}, {6, 3}}}};
  EXPECT_TRUE(verify(path_through({{9, 1}, {6, 2}, {5, 2}}), space, {9, 1}, room).valid);
  const Verdict verdict = verify(path_through({{1, 1}, {5, 2.5}}), space, {1, 1}, room);
  EXPECT_FALSE(verdict.valid);
  EXPECT_THAT(verdict.reason, HasSubstr("cannot enter"));
}

TEST(VerifyRoom, AcceptsAnEndOnAnOpenSideThoughAWallInTheRoomHidesItsMiddle) {
  const FreeSpace space = kOneWall.space();
  const Goal room{std::nullopt, {{{4, 2}, {7, 3}}}};
  EXPECT_TRUE(verify(path_through({{1, 1}, {4, 2.5}}), space, {1, 1}, room).valid);
  EXPECT_TRUE(verify(path_through({{1, 1}, {4.5, 2.5}}), space, {1, 1}, room).valid);
  EXPECT_TRUE(verify(path_through({{9, 1}, {7, 2.5}}), space, {9, 1}, room).valid);
  EXPECT_FALSE(verify(path_through({{1, 1}, {6, 2.5}}), space, {1, 1}, room).valid);
}

TEST(VerifyRoom, AcceptsAnEndAtTheMiddleOfTheRoomItself) {
  const Goal room{std::nullopt, {{{6, 2}, {8, 4}}}};
  EXPECT_TRUE(verify(path_through({{9, 1}, {7, 3}}), kOneWall.space(), {9, 1}, room).valid);
}

TEST(VerifyClearance, IsTheLeastDistanceToTheNearestDouble) {
  const FreeSpace space = kOneWall.space();
  const Verdict beside = verify(path_through({{1, 1}, {1, 9}}), space, {1, 1}, at({1, 9}));
  EXPECT_EQ(beside.clearance, 1);
  const Verdict over = verify(path_through({{3, 7}, {7, 8}}), space, {3, 7}, at({7, 8}));
  EXPECT_EQ(over.clearance, 6 / std::sqrt(17.0)) << "of the wall's end";
  const Constraint& nearest = space.constraints()[over.nearest];
  EXPECT_TRUE(nearest.is_wall());
}

TEST(VerifyClearance, TellsNearlyEqualDistancesApart) {
  const double off = 2 + 0x1p-50;
  const SmallWorld world{.walls = {{{4, 3}, {6, 3}}, {{4, 5 + off}, {6, 5 + off}}}, .solids = {}};
  const FreeSpace space = world.space();
  const Verdict verdict = verify(path_through({{4.5, 5}, {5.5, 5}}), space, {4.5, 5}, at({5.5, 5}));
  EXPECT_EQ(verdict.clearance, 2);
  EXPECT_EQ(space.constraints()[verdict.nearest].a.y, 3);
}

TEST(VerifyClearance, IsZeroWhenThePathIsRefusedForCrossing) {
  const Verdict verdict = check(kOneWall, {{1, 1}, {9, 1}});
  EXPECT_EQ(verdict.clearance, 0);
}

TEST(VerifyClearance, LeavesOutTheWayIntoTheRoom) {
  const SmallWorld world{.walls = {{{7, 7}, {9, 7}}}, .solids = {}};
  const Goal room{std::nullopt, {{{6, 6}, {9, 8}}}};
  const Verdict verdict = verify(path_through({{3, 3}, {6, 6}}), world.space(), {3, 3}, room);
  EXPECT_TRUE(verdict.valid) << verdict.reason;
  EXPECT_EQ(verdict.clearance, std::sqrt(2.0));
}

}  // namespace
}  // namespace taut
