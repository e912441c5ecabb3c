#include <taut/search/disc_passage.h>

#include <gtest/gtest.h>

#include <taut/geometry/maze_generator.h>
#include <algorithm>
#include <cmath>
#include <memory>

#include "support/passage_opinions.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::inflated;
using test::separates;
using test::SmallWorld;

World room(const std::vector<Segment>& walls) {
  return SmallWorld{.walls = walls, .solids = {}}.bounded(Boundary::walled);
}

/// Two rooms, one above the other, and doors between them: from x to x + width.
World rooms_with_doors(const std::vector<std::pair<double, double>>& doors) {
  std::vector<Segment> walls;
  double x = 0;
  for (const auto& [at, width] : doors) {
    walls.push_back({{x, 5}, {at, 5}});
    x = at + width;
  }
  walls.push_back({{x, 5}, {10, 5}});
  return room(walls);
}

DiscStatus status(const World& world, Point s, Point g, double r) {
  return disc_passage(FreeSpace(world), s, g, r).status;
}

TEST(DiscPassage, ADoorLetsThroughWhatIsNoWiderThanIt) {
  const World world = rooms_with_doors({{4, 2}});
  EXPECT_EQ(status(world, {5, 2}, {5, 8}, 1), DiscStatus::found);
  EXPECT_EQ(status(world, {5, 2}, {5, 8}, std::nextafter(1, 2)), DiscStatus::none);
}

TEST(DiscPassage, TheWiderOfTwoDoorsCounts) {
  const World world = rooms_with_doors({{1, 1}, {6, 1.5}});
  const Gates gates{FreeSpace(world)};
  const auto widest = widest_passage(gates, {5, 2}, {5, 8});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->limit, WidestPassage::Limit::gate);
  EXPECT_EQ(widest->radius, 0.75);
  EXPECT_EQ(gates.name(widest->gate), "3/2 between (6, 5) and (7.5, 5)");
}

TEST(DiscPassage, TheBarrierNamesTheGatesAndClosesAroundOneEnd) {
  const Gates gates{FreeSpace(rooms_with_doors({{1, 1}, {6, 1.5}}))};
  const DiscPassage blocked = disc_passage(gates, {5, 2}, {5, 8}, 0.8);
  ASSERT_EQ(blocked.status, DiscStatus::none);
  EXPECT_EQ(
      std::count_if(blocked.barrier.begin(), blocked.barrier.end(), [](const auto& p) { return p.gate != kNone; }), 2);
  EXPECT_TRUE(separates(gates, blocked.barrier, {5, 2}, {5, 8}));
}

TEST(DiscPassage, AnEndNearAWallIsNoPlace) {
  const Gates gates{FreeSpace(room({{{3, 3}, {7, 3}}}))};
  EXPECT_EQ(disc_passage(gates, {5, 3.5}, {5, 8}, 0.6).status, DiscStatus::start_blocked);
  EXPECT_EQ(disc_passage(gates, {5, 8}, {5, 3.5}, 0.6).status, DiscStatus::goal_blocked);
  EXPECT_EQ(disc_passage(gates, {5, 8}, {5, 3.5}, 0.5).status, DiscStatus::found);
  EXPECT_EQ(disc_passage(gates, {11, 8}, {5, 3.5}, 0.5).status, DiscStatus::start_blocked);
  const auto widest = widest_passage(gates, {5, 8}, {5, 3.5});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->limit, WidestPassage::Limit::goal);
  EXPECT_EQ(widest->radius, 0.5);
}

TEST(DiscPassage, ClosedRoomsAreSeparatedForAnyRadius) {
  const Gates gates{FreeSpace(room({{{0, 5}, {10, 5}}}))};
  EXPECT_FALSE(widest_passage(gates, {5, 2}, {5, 8}));
  const DiscPassage blocked = disc_passage(gates, {5, 2}, {5, 8}, 1e-6);
  EXPECT_EQ(blocked.status, DiscStatus::none);
  EXPECT_TRUE(separates(gates, blocked.barrier, {5, 2}, {5, 8}));
}

TEST(DiscPassage, AnEndOnAWallStandsOnBothOfItsSides) {
  // The wall closes off the upper room; a point on it can be reached from either.
  const Gates gates{FreeSpace(room({{{0, 5}, {10, 5}}}))};
  for (const Point p : {Point{5, 2}, {5, 8}}) {
    const auto widest = widest_passage(gates, p, {5, 5});
    ASSERT_TRUE(widest);
    EXPECT_EQ(widest->radius, 0);
    EXPECT_EQ(widest->limit, WidestPassage::Limit::goal);
  }
}

TEST(DiscPassage, APostInTheMiddleOfACorridorLeavesTheWiderSide) {
  const Gates gates{FreeSpace(room({{{0, 4}, {10, 4}}, {{0, 6}, {10, 6}}, {{5, 5.25}, {5.25, 5.25}}}))};
  const auto widest = widest_passage(gates, {2, 5}, {8, 5});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->radius, 0.625);
}

TEST(DiscPassage, ADiscSticksOutOfAnOpening) {
  // The fence on the right does not exist for the disc; its centre stays within.
  const SmallWorld world{.walls = {{{0, 0}, {10, 0}}, {{0, 10}, {10, 10}}, {{0, 0}, {0, 10}}, {{0, 5}, {9, 5}}},
                         .solids = {}};
  const Gates gates(world.space());
  EXPECT_EQ(disc_passage(gates, {5, 2}, {5, 8}, 1).status, DiscStatus::found);
  EXPECT_EQ(disc_passage(gates, {10, 2}, {10, 8}, 1).status, DiscStatus::found);
  EXPECT_EQ(disc_passage(gates, {10, 2}, {10, 8}, 1.01).status, DiscStatus::none);
  EXPECT_EQ(disc_passage(gates, {10, 5}, {10, 8}, 1).status, DiscStatus::found);
}

TEST(DiscPassage, AWallOnTheOutlineOfAnOpenWorldIsAWall) {
  auto parts = SmallWorld{.walls = {{{0, 0}, {0, 1}}}, .solids = {}}.parts();
  parts.boundary = Boundary::open;
  const FreeSpace space{World(parts)};
  EXPECT_EQ(disc_passage(space, {0.25, 0.5}, {5, 5}, 0.5).status, DiscStatus::start_blocked);
  EXPECT_EQ(disc_passage(space, {0.25, 2}, {5, 5}, 0.5).status, DiscStatus::found);
}

TEST(DiscPassage, AWallReachesOutThroughAnOpening) {
  // A slot that is not part of the world, between a wall and a door's other post: the centre cannot be there, but the
  // disc can.
  WorldParts parts;
  parts.areas.push_back({Polygon{test::box_ring(0, 0, 10, 10), {{{4.8, 2}, {4.8, 8}, {5, 8}, {5, 2}}}}, 0});
  parts.boundary = Boundary::limit;
  for (const auto& [a, b] : std::vector<Segment>{
           {{0, 5}, {4.5, 5}}, {{4.5, 3}, {4.5, 7}}, {{6.8, 5}, {10, 5}}, {{0, 0}, {0, 10}}, {{10, 0}, {10, 10}}})
    parts.walls.push_back({a, b, 0, 0});
  const World world(parts);
  const Point s{2.5, 2}, g{2.5, 8};
  const Gates gates{FreeSpace(world)};
  const auto widest = widest_passage(gates, s, g);
  ASSERT_TRUE(widest);
  EXPECT_NEAR(widest->radius, 1.15, 1e-12);
  EXPECT_EQ(gates.name(widest->gate), "23/10 between (4.5, 5) and (6.8, 5)");
  EXPECT_EQ(inflated(world, s, g, 1.145), true);
  EXPECT_EQ(inflated(world, s, g, 1.155), false);
}

TEST(DiscPassage, AnEmptyWorldHasNoLimit) {
  WorldParts parts;
  parts.areas.push_back({Polygon{test::box_ring(0, 0, 10, 10), {}}, 0});
  parts.boundary = Boundary::open;
  const auto widest = widest_passage(FreeSpace(World(parts)), {5, 2}, {5, 8});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->limit, WidestPassage::Limit::none);
}

TEST(DiscPassage, FromOpeningToOpeningOfAMaze) {
  for (const int seed : {1, 2, 3, 4, 5}) {
    const World world = world_of(std::make_shared<GridMaze>(generate_biased_maze(8, 12, seed)));
    const Gates gates{FreeSpace(world)};
    const auto widest = widest_passage(gates, *world.start(), *world.goal().point);
    ASSERT_TRUE(widest);
    EXPECT_EQ(widest->radius, 0.5);
    EXPECT_EQ(inflated(world, *world.start(), *world.goal().point, 0.49), true);
    EXPECT_EQ(disc_passage(gates, *world.start(), *world.goal().point, 0.5).status, DiscStatus::found);
  }
}

}  // namespace
}  // namespace taut
