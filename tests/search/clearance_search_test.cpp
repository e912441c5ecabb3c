#include <taut/search/clearance_search.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/maze_generator.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::box_ring;
using test::SmallWorld;

ClearanceSearch search(const FreeSpace& space, Point from, Point to) {
  return ClearanceSearch(VoronoiRoadmap(space), from, to);
}

/// Two rooms of 10 x 10; the wall between them has a door of width 2 from (10, 4) to (10, 6).
SmallWorld two_rooms() {
  return {.walls = {{{10, 0}, {10, 4}}, {{10, 6}, {10, 10}}}, .solids = {}, .area = box_ring(0, 0, 20, 10)};
}

/// Is there a way for a disc, by the inflated obstacles? Shares nothing with the diagram.
bool disc_passes(const World& world, double r, Point from, Point to) {
  WorldParts parts;
  parts.areas = world.areas();
  parts.boundary = Boundary::walled;  // a mere limit would not be inflated
  parts.walls = world.walls();
  parts.solids = world.solids();
  const FreeSpace space(World(std::move(parts)), Footprint::disc(r));
  const Location a = space.locate(from), b = space.locate(to);
  if (a.kind == Location::Kind::outside || b.kind == Location::Kind::outside) return false;
  return space.component(a.triangle) == space.component(b.triangle);
}

/// Least clearance at points along the path, by the triangulation; a straight edge can be narrowest in its middle.
double sampled_clearance(const FreeSpace& space, const ClearancePath& path) {
  double least = HUGE_VAL;
  for (const Bezier& c : path.curves)
    for (int i = 0; i <= 64; ++i) {
      const double t = i / 64.0, s = 1 - t;
      const Point p{s * s * c.from.x + 2 * s * t * c.control.x + t * t * c.to.x,
                    s * s * c.from.y + 2 * s * t * c.control.y + t * t * c.to.y};
      least = std::min(least, space.clearance(p).distance);
    }
  return least;
}

void expect_widest_agrees_with_discs(const FreeSpace& space, Point from, Point to) {
  const auto widest = search(space, from, to).widest();
  ASSERT_TRUE(widest);
  const double r = widest->pinch.clearance;
  // The disc of FreeSpace is a 64-gon around it, too large by up to kDiscExcess.
  EXPECT_TRUE(disc_passes(space.world(), r * (1 - 1.01 * Footprint::kDiscExcess), from, to)) << r;
  EXPECT_FALSE(disc_passes(space.world(), r * 1.000001, from, to)) << r;
  EXPECT_GE(sampled_clearance(space, *widest), r - 1e-9);
  EXPECT_LE(sampled_clearance(space, *widest), r + 0.05);
}

TEST(ClearanceSearch, NamesTheDoorPostsThatPinchTheWidestPath) {
  const FreeSpace space = two_rooms().space();
  const auto widest = search(space, {3, 5}, {17, 5}).widest();
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->pinch.where, Pinch::Where::gate);
  EXPECT_EQ(widest->pinch.clearance, 1);
  EXPECT_EQ(std::min(widest->pinch.posts[0], widest->pinch.posts[1]), (Point{10, 4}));
  EXPECT_EQ(std::max(widest->pinch.posts[0], widest->pinch.posts[1]), (Point{10, 6}));
  for (int i = 0; i < 2; ++i) {
    const Constraint& c = space.constraints()[widest->pinch.constraints[i]];
    EXPECT_TRUE(c.a == widest->pinch.posts[i] || c.b == widest->pinch.posts[i]);
  }
}

TEST(ClearanceSearch, LetsADiscAsWideAsTheDoorThroughAndNoWiderOne) {
  const ClearanceSearch query = search(two_rooms().space(), {3, 5}, {17, 5});
  EXPECT_TRUE(query.shortest(1));
  EXPECT_FALSE(query.shortest(std::nextafter(1, 2)));
}

TEST(ClearanceSearch, NamesTheEndThatStandsNearestToAWall) {
  const auto widest = search(two_rooms().space(), {3, 5}, {17, 9.75}).widest();
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->pinch.where, Pinch::Where::goal);
  EXPECT_EQ(widest->pinch.clearance, 0.25);
  EXPECT_EQ(widest->pinch.posts[0], (Point{17, 10}));
  EXPECT_EQ(widest->curves.back().to, (Point{17, 9.75}));
}

TEST(ClearanceSearch, FindsNothingBetweenSeparateRooms) {
  SmallWorld world = two_rooms();
  world.walls.push_back({{10, 4}, {10, 6}});
  const ClearanceSearch query = search(world.space(), {3, 5}, {17, 5});
  EXPECT_FALSE(query.shortest(0));
  EXPECT_FALSE(query.widest());
  EXPECT_TRUE(query.tradeoff().empty());
}

TEST(ClearanceSearch, DoesNotSlipThroughAPointWhereBlocksTouch) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {box_ring(0, 0, 5, 5), box_ring(5, 5, 10, 10)}}.space();
  EXPECT_FALSE(search(space, {2, 8}, {8, 2}).shortest(0));
}

TEST(ClearanceSearch, GoesTheLongWayRoundForAWiderDisc) {
  // The direct door is 1 wide; another one at the top is 3 wide.
  const SmallWorld world{.walls = {{{10, 0}, {10, 2}}, {{10, 3}, {10, 16}}, {{10, 19}, {10, 20}}},
                         .solids = {},
                         .area = box_ring(0, 0, 20, 20)};
  const ClearanceSearch query = search(world.space(), {5, 5}, {15, 5});
  const auto front = query.tradeoff();
  ASSERT_EQ(front.size(), 2u);
  EXPECT_EQ(front[0].clearance, 0.5);
  EXPECT_EQ(front[1].clearance, 1.5);
  EXPECT_LT(front[0].path.length, front[1].path.length);
  EXPECT_EQ(front[0].path.length, query.shortest(0.5)->length);
  EXPECT_EQ(front[1].path.length, query.shortest(0.51)->length);
  EXPECT_EQ(front[1].path.length, query.widest()->length);
}

TEST(ClearanceSearch, CrossesAPlusShapedMazeThroughItsMiddle) {
  const FreeSpace space =
      SmallWorld{.walls = {},
                 .solids = {box_ring(0, 0, 4, 4), box_ring(6, 0, 10, 4), box_ring(0, 6, 4, 10), box_ring(6, 6, 10, 10)}}
          .space();
  const auto path = search(space, {1, 5}, {5, 9}).widest();
  ASSERT_TRUE(path);
  EXPECT_EQ(path->pinch.clearance, 1);
  EXPECT_NEAR(path->length, 8, 1e-12);
}

TEST(ClearanceSearch, StartsAtWallsAndCornersAndOpenings) {
  const FreeSpace space = two_rooms().space();
  for (const Point p : {Point{0, 0}, {10, 4}, {10, 0}, {10, 2}, {0, 3}, {10, 10}}) {
    const auto path = search(space, p, {17, 5}).shortest(0);
    ASSERT_TRUE(path) << p.x << ' ' << p.y;
    EXPECT_EQ(path->pinch.clearance, 0);
    EXPECT_EQ(path->curves.front().from, p);
  }
}

TEST(ClearanceSearch, HasNoLengthBetweenAPointAndItself) {
  const auto path = search(two_rooms().space(), {3, 5}, {3, 5}).widest();
  ASSERT_TRUE(path);
  EXPECT_EQ(path->pinch.clearance, 3);
}

TEST(ClearanceSearch, AgreesWithInflatedObstaclesInGeneratedMazes) {
  for (int cells = 5; cells <= 15; cells += 5) {
    for (const double opened : {0.0, 0.3, 0.9}) {
      SCOPED_TRACE(testing::Message() << cells << " cells, opened " << opened);
      auto grid = std::make_shared<GridMaze>(generate_backtracker(cells, cells, 7));
      open_walls(*grid, opened, 7);
      const FreeSpace space(world_of(grid));
      const double last = cells - 0.5;
      expect_widest_agrees_with_discs(space, {0.5, 0.5}, {last, last});
      expect_widest_agrees_with_discs(space, {0.625, 0.5}, {last, 0.375});
    }
  }
}

/// The widest path against inflated obstacles, and every entry of the front against its neighbours.
RC_GTEST_PROP(ClearanceSearch, AgreesWithInflatedObstaclesInMessyWorlds, ()) {
  const SmallWorld world = test::any_world();
  const Point from{test::any(1, 23) / 4.0 + 0.0625, test::any(1, 23) / 4.0},
      to{test::any(1, 23) / 4.0, test::any(1, 23) / 4.0 + 0.03125};
  RC_LOG() << test::show(world) << test::show(from) << test::show(to);
  const FreeSpace space = world.space();
  for (const Point p : {from, to}) RC_PRE(space.locate(p).kind == Location::Kind::triangle);
  for (const Point p : {from, to}) RC_PRE(space.clearance(p).distance > 0);
  const ClearanceSearch query = search(space, from, to);
  const auto widest = query.widest();
  const bool connected = space.component(space.locate(from).triangle) == space.component(space.locate(to).triangle);
  RC_ASSERT(bool(widest) == connected);
  if (!widest) return;
  const double r = widest->pinch.clearance;
  RC_ASSERT(r > 0);
  if (from == to) return;
  RC_ASSERT(sampled_clearance(space, *widest) >= r - 1e-9);
  RC_ASSERT(sampled_clearance(space, *widest) <= r + 0.05);
  RC_ASSERT(disc_passes(space.world(), r * (1 - 1.01 * Footprint::kDiscExcess), from, to));
  RC_ASSERT(!disc_passes(space.world(), r * 1.000001, from, to));
  const auto front = query.tradeoff();
  RC_ASSERT(!front.empty());
  RC_ASSERT(front.back().clearance == r);
  for (std::size_t i = 0; i + 1 < front.size(); ++i) {
    RC_ASSERT(front[i].clearance < front[i + 1].clearance);
    RC_ASSERT(front[i].path.length <= front[i + 1].path.length);
    RC_ASSERT(query.shortest(std::nextafter(front[i].clearance, 9))->length == front[i + 1].path.length);
  }
}

}  // namespace
}  // namespace taut
