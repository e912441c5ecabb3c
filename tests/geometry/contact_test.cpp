#include <taut/geometry/contact.h>

#include <cmath>

#include <gtest/gtest.h>

#include "support/constraint_walk.h"

namespace taut {
namespace {

using test::add_solid;
using test::Constraints;
using test::follows;
using test::wall;
using test::walls;

TEST(Contact, TellsTouchingFromCrossing) {
  const Segment leg{{0, 0}, {4, 0}};
  EXPECT_EQ(contact(leg, wall({2, -1}, {2, 1})), Contact::cross);
  EXPECT_EQ(contact(leg, wall({2, 0}, {2, 1})), Contact::touch);
  EXPECT_EQ(contact(leg, wall({4, -1}, {4, 1})), Contact::touch);
  EXPECT_EQ(contact(leg, wall({4, 0}, {5, 0})), Contact::touch);
  EXPECT_EQ(contact(leg, wall({5, 0}, {6, 0})), Contact::none);
  EXPECT_EQ(contact(leg, wall({1, 1}, {3, 1})), Contact::none);
  EXPECT_EQ(contact(leg, wall({5, -1}, {5, 1})), Contact::none);
  EXPECT_EQ(contact(leg, wall({2, 0.1}, {9, -0.1})), Contact::none);
  EXPECT_EQ(contact({{2, 0}, {2, 0}}, wall({0, 0}, {4, 0})), Contact::touch);
  EXPECT_EQ(contact({{2, 1}, {2, 1}}, wall({0, 0}, {4, 0})), Contact::none);
}

TEST(Contact, IsDecidedByTheLastBit) {
  const double up = 0x1p-60;
  const Segment leg{{0, 0}, {3, 1}};
  EXPECT_EQ(contact(leg, wall({1.5, 0.5}, {1.5, 2})), Contact::touch);
  EXPECT_EQ(contact(leg, wall({1.5, std::nextafter(0.5, 1)}, {1.5, 2})), Contact::none);
  EXPECT_EQ(contact({{0, up}, {3, 1}}, wall({1.5, 0.5}, {1.5, 2})), Contact::cross);
}

TEST(Star, NumbersSectorsCounterClockwise) {
  const Constraints c = walls({{{0, 0}, {0, -1}}, {{0, 0}, {1, 0}}, {{-1, 1}, {1, -1}}});
  const Star star = test::star({0, 0}, c);
  ASSERT_EQ(star.sector_count(), 4u);
  EXPECT_EQ(star.rays()[0].towards, (Point{1, 0}));
  EXPECT_EQ(star.rays()[1].towards, (Point{-1, 1}));
  EXPECT_EQ(star.rays()[2].towards, (Point{0, -1}));
  EXPECT_EQ(star.rays()[3].towards, (Point{1, -1}));
  EXPECT_EQ(star.sector_left_of({5, 0}), 0u);
  EXPECT_EQ(star.sector_left_of({5, 5}), 0u);
  EXPECT_EQ(star.sector_left_of({-5, 0}), 1u);
  EXPECT_EQ(star.sector_left_of({5, -1}), 3u);
  EXPECT_FALSE(star.reflex(0) || star.reflex(1) || star.reflex(2) || star.reflex(3));
}

TEST(Star, KnowsReflexAndSolidSectors) {
  Constraints c;
  add_solid(c, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  const Star corner = test::star({2, 2}, c);
  ASSERT_EQ(corner.free_sectors().size(), 1u);
  EXPECT_TRUE(corner.reflex(corner.free_sectors()[0]));
  const Star side = test::star({1, 2}, c);
  EXPECT_EQ(side.free_sectors(), (Sectors{0}));
  EXPECT_FALSE(side.reflex(0));
  EXPECT_TRUE(test::star({7, 7}, c).free_sectors() == Sectors{0});
  EXPECT_TRUE(test::star({0, 1}, walls({{{0, 0}, {0, 1}}})).reflex(0));
}

TEST(Star, IsTangentWhenAllItsRaysLieOnOneSide) {
  const Star star = test::star({0, 0}, walls({{{0, 0}, {1, 0}}, {{0, 0}, {1, 1}}}));
  EXPECT_TRUE(star.tangent({5, 0}));
  EXPECT_TRUE(star.tangent({-5, 0}));
  EXPECT_TRUE(star.tangent({0, 5}));
  EXPECT_FALSE(star.tangent({2, 1}));
  EXPECT_FALSE(star.tangent({-2, -1}));
}

//   o---o---o     a joint in the middle of a straight wall
TEST(PathAmongWalls, RefusesTheJointOfTwoWalls) {
  const Constraints c = walls({{{0, 0}, {1, 0}}, {{1, 0}, {2, 0}}});
  EXPECT_FALSE(follows({{1, -1}, {1, 1}}, c));
  EXPECT_FALSE(follows({{1, -1}, {1, 0}, {1, 1}}, c));
  EXPECT_FALSE(follows({{1, -1}, {1, 0}, {2, 1}}, c));
  EXPECT_TRUE(follows({{1, -1}, {1, 0}, {2, -1}}, c));
  EXPECT_TRUE(follows({{1, -1}, {1, 0}, {1, -1}}, c));
}

TEST(PathAmongWalls, RefusesTheOutsideOfACornerFromWithin) {
  const Constraints c = walls({{{0, 0}, {2, 0}}, {{0, 0}, {0, 2}}});
  EXPECT_FALSE(follows({{1, 1}, {-1, -1}}, c));
  EXPECT_TRUE(follows({{-1, 1}, {1, -1}}, c));
  EXPECT_TRUE(follows({{-1, 1}, {0, 0}, {1, -1}}, c));
  EXPECT_FALSE(follows({{1, 1}, {0, 0}, {1, -1}}, c));
  EXPECT_TRUE(follows({{1, 1}, {0, 0}, {2, 1}}, c));
}

TEST(PathAmongWalls, MayTouchAndTurnAroundAFreeEnd) {
  const Constraints c = walls({{{0, 0}, {0, 2}}});
  EXPECT_TRUE(follows({{-1, 2}, {1, 2}}, c));
  EXPECT_TRUE(follows({{-1, 1}, {0, 2}, {1, 1}}, c));
  EXPECT_TRUE(follows({{-1, 0}, {0, 1}, {0, 2}, {0, 1}, {1, 0}}, c))
      << "up the left side, around the end, down the right";
  EXPECT_FALSE(follows({{-1, 0}, {0, 1}, {1, 0}}, c));
  EXPECT_FALSE(follows({{-1, 0}, {0, 1.5}, {0, 1}, {1, 0}}, c)) << "turns before the end";
  EXPECT_TRUE(follows({{0, 3}, {0, -1}}, c)) << "over both ends and along it";
}

TEST(PathAmongWalls, KeepsItsSideWhileRunningAlongAWall) {
  const Constraints c = walls({{{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}});
  EXPECT_TRUE(follows({{1, 1}, {2, 0}, {3, 0}, {3, 1}}, c));
  EXPECT_FALSE(follows({{1, 1}, {2, 0}, {3, 0}, {3, -1}}, c));
  EXPECT_TRUE(follows({{1, -1}, {2, 0}, {4, 0}, {4, 2}, {5, 2}}, c)) << "around the outer corner";
  EXPECT_FALSE(follows({{1, -1}, {2, 0}, {4, 0}, {4, 2}, {3, 2}}, c));
  EXPECT_TRUE(follows({{1, 1}, {2, 0}, {4, 0}, {4, 2}, {3, 2}}, c)) << "into the inner corner and out";
}

TEST(PathAmongWalls, MayChangeSidesOnlyBetweenWalls) {
  const Constraints apart = walls({{{0, 0}, {1, 0}}, {{2, 0}, {3, 0}}});
  EXPECT_TRUE(follows({{0.5, 1}, {0.5, 0}, {2.5, 0}, {2.5, -1}}, apart));
  const Constraints joined = walls({{{0, 0}, {1, 0}}, {{1, 0}, {2, 0}}, {{2, 0}, {3, 0}}});
  EXPECT_FALSE(follows({{0.5, 1}, {0.5, 0}, {2.5, 0}, {2.5, -1}}, joined));
  EXPECT_TRUE(follows({{0.5, 1}, {0.5, 0}, {2.5, 0}, {2.5, 1}}, joined));
}

//       |
//   ----+----
TEST(PathAmongWalls, MeetsATJoint) {
  const Constraints c = walls({{{-2, 0}, {0, 0}}, {{0, 0}, {2, 0}}, {{0, 0}, {0, 2}}});
  EXPECT_TRUE(follows({{-2, 0}, {2, 0}}, c)) << "along the flat side";
  EXPECT_TRUE(follows({{-1, -1}, {0, 0}, {1, -1}}, c));
  EXPECT_FALSE(follows({{-1, 1}, {-1, 0}, {2, 0}}, c)) << "the stem is in the way";
  EXPECT_FALSE(follows({{-1, 1}, {0, 0}, {1, 1}}, c));
  EXPECT_FALSE(follows({{0, 1}, {0, -1}}, c));
  EXPECT_TRUE(follows({{-1, 1}, {0, 0}, {0, 2}, {0, 0}, {1, 1}}, c)) << "down the other side of the stem";
  EXPECT_FALSE(follows({{-1, 1}, {0, 0}, {0, 1}, {0, 0}, {1, 1}}, c));
}

TEST(PathAmongWalls, MayStartOnAWallOrAJointOnAnySide) {
  const Constraints c = walls({{{-2, 0}, {0, 0}}, {{0, 0}, {2, 0}}, {{0, 0}, {0, 2}}});
  for (const Point to : {Point{-1, 1}, Point{1, 1}, Point{0, -1}, Point{2, 0}, Point{0, 2}})
    EXPECT_TRUE(follows({{0, 0}, to}, c)) << to.x << ' ' << to.y;
  EXPECT_TRUE(follows({{1, 0}, {1, 1}}, c));
  EXPECT_TRUE(follows({{1, 0}, {1, -1}}, c));
  EXPECT_FALSE(follows({{1, 0}, {1, 1}, {1, 0}, {1, -1}}, c));
  EXPECT_TRUE(follows({{1, 1}, {0, 0}}, c));
  EXPECT_TRUE(follows({{1, 1}}, c));
}

TEST(PathAmongWalls, RefusesAFanOfWallsAtAnyPlaceButItsOpening) {
  Constraints c;
  for (const Point end : {Point{2, 0}, Point{2, 1}, Point{1, 2}, Point{0, 2}, Point{-1, 2}, Point{-2, 1}})
    c.push_back(wall({0, 0}, end));
  EXPECT_FALSE(follows({{2, 0.5}, {0, 0}, {2, -1}}, c));
  EXPECT_FALSE(follows({{2, 0.5}, {0, 0}, {1, 1}}, c));
  EXPECT_TRUE(follows({{2, 0.5}, {0, 0}, {4, 1.5}}, c));
  EXPECT_TRUE(follows({{2, 0}, {-2, 0}}, c)) << "along the lower side of the first wall";
  EXPECT_TRUE(follows({{2, -1}, {-4, 2}}, c)) << "along the lower side of the last wall";
  EXPECT_FALSE(follows({{-2, 1.5}, {2, -1.5}}, c));
}

// Two blocks that touch at a corner.
TEST(PathAmongSolids, RefusesTheGapBetweenTwoCornersThatTouch) {
  Constraints c;
  add_solid(c, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  add_solid(c, {{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  EXPECT_FALSE(follows({{0, 2}, {2, 0}}, c));
  EXPECT_FALSE(follows({{0.5, 1.5}, {1, 1}, {1.5, 0.5}}, c));
  EXPECT_FALSE(follows({{1, 2}, {1, 0}}, c)) << "down the left of the upper block, then the right of the lower";
  EXPECT_TRUE(follows({{1, 3}, {1, 1}, {-1, 1}}, c));
  EXPECT_TRUE(follows({{0.5, 1.5}, {1, 1}, {0.5, 1.25}}, c));
}

TEST(PathAmongSolids, RunsAlongASideButNotInside) {
  Constraints c;
  add_solid(c, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  EXPECT_TRUE(follows({{-1, 0}, {3, 0}}, c));
  EXPECT_TRUE(follows({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}, c));
  EXPECT_FALSE(follows({{0, 0}, {2, 2}}, c));
  EXPECT_FALSE(follows({{1, 0}, {1, 2}}, c));
  EXPECT_FALSE(follows({{1, 0}, {2, 1}}, c));
  EXPECT_TRUE(follows({{-1, 1}, {1, 3}}, c)) << "grazes the corner";
  EXPECT_TRUE(follows({{1, 0}, {0, 0}, {0, 1}}, c));
}

TEST(PathAmongSolids, StaysOnItsSideOfTheSeamThatMeetsTheOutline) {
  Constraints c;
  add_solid(c, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  c.push_back(wall({1, 3}, {1, 2}));
  c[2] = {{2, 2}, {1, 2}, true, false, kNone};
  c.push_back({{1, 2}, {0, 2}, true, false, kNone});
  EXPECT_FALSE(follows({{2, 2}, {0, 2}}, c));
  EXPECT_FALSE(follows({{2, 3}, {1, 2}, {0, 3}}, c));
  EXPECT_TRUE(follows({{2, 2}, {1, 2}, {1, 3}, {1, 2}, {0, 2}}, c));
}

TEST(PathAmongSolids, HasNoPlaceWhereSolidsMeetAllAround) {
  Constraints c;
  add_solid(c, {{0, 0}, {2, 0}, {0, 2}});
  c[0].solid_right = c[2].solid_right = true;
  EXPECT_TRUE(test::star({0, 0}, c).free_sectors().empty());
  EXPECT_FALSE(follows({{0, 0}, {-1, 0}}, c));
}

}  // namespace
}  // namespace taut
