// Tangent Bug: what it sees decides where it goes, and nothing else does. That it arrives whenever there is a way is in
// bug_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/geometry/predicates.h>
#include <taut/robots/bug/bug.h>
#include <taut/robots/bug/detail/rational.h>
#include <taut/search/funnel.h>
#include <taut/search/shortest_path.h>

#include "support/messy_world.h"
#include "support/small_world.h"

namespace taut::bug {
namespace {

using test::box_ring;
using test::SmallWorld;
using testing::ElementsAre;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Options sees(double range, Turn turn = Turn::left) { return {Algorithm::tangent, turn, range, true}; }

const FreeSpace& block() {
  static const FreeSpace space = SmallWorld{.solids = {box_ring(3, 3, 7, 7)}}.space();
  return space;
}

//    +--------+
//  S |        |  G     a block of 4 x 4 in the way
//    +--------+
TEST(TangentBug, GoesStraightForTheCornersThatItSees) {
  const Journey left = travel(block(), {1, 5}, {9, 5}, sees(kInfinity));
  EXPECT_THAT(left.path.points, ElementsAre(Point{1, 5}, Point{3, 7}, Point{7, 7}, Point{9, 5}));
  const Journey right = travel(block(), {1, 5}, {9, 5}, sees(kInfinity, Turn::right));
  EXPECT_THAT(right.path.points, ElementsAre(Point{1, 5}, Point{3, 3}, Point{7, 3}, Point{9, 5}));
  EXPECT_TRUE(left.minima.empty());
  EXPECT_EQ(left.obstacles[0].legs, 2U);
  // Two legs, each at most twice the distance of its corner from the goal.
  EXPECT_NEAR(left.bound.hi, 8 + 2 * std::sqrt(40) + 2 * std::sqrt(8), 1e-9);
}

TEST(TangentBug, OnlyTouchesWithRangeZero) {
  const Journey j = travel(block(), {1, 5}, {9, 5}, sees(0));
  EXPECT_THAT(j.path.points, ElementsAre(Point{1, 5}, Point{3, 5}, Point{3, 7}, Point{7, 7}, Point{9, 5}));
  ASSERT_EQ(j.minima.size(), 1U);
  EXPECT_EQ(j.minima[0].at, (Point{3, 5}));
  ASSERT_EQ(j.leaves.size(), 1U);
  EXPECT_EQ(j.leaves[0].at, (Point{7, 7}));
  EXPECT_NEAR(j.bound.hi, 8 + 1.5 * 16, 1e-9);
  EXPECT_TRUE(j.views.empty());
}

TEST(TangentBug, GoesOnUntilWhatBlocksItIsInRange) {
  const Journey j = travel(block(), {0.5, 5}, {9, 5}, sees(1.5));
  ASSERT_EQ(j.hits.size(), 1U);
  EXPECT_NEAR(j.hits[0].at.x, 1.5, 1e-8);
  EXPECT_EQ(j.hits[0].at.y, 5);
  // All corners are farther away than it sees.
  EXPECT_EQ(j.obstacles[0].legs, 0U);
  EXPECT_EQ(j.minima.size(), 1U);
}

//   +-----------+
//   | S         |  G     nothing is hidden in a convex room
//   +-----------+
TEST(TangentBug, ProvesWithoutAStepThatAConvexRoomHasNoWayOut) {
  const FreeSpace room =
      SmallWorld{.walls = {{{3, 3}, {7, 3}}, {{7, 3}, {7, 7}}, {{7, 7}, {3, 7}}, {{3, 7}, {3, 3}}}}.space();
  const Journey j = travel(room, {5, 4}, {9, 5}, sees(kInfinity));
  EXPECT_FALSE(j.reached);
  EXPECT_EQ(j.path.points.size(), 1U);
  const Journey by_touch = travel(room, {5, 4}, {9, 5}, sees(0));
  EXPECT_FALSE(by_touch.reached);
  EXPECT_GE(by_touch.path.length.value(), 16);
}

//   +--------+
//         S  |      G     out of a pocket, farther from the goal at first: M at the start, L where
//   +--------+            something nearer than the whole pocket is seen
TEST(TangentBug, FollowsAPocketUntilItSeesSomethingNearerThanTheWholeOfIt) {
  const FreeSpace pocket = SmallWorld{.walls = {{{2, 3}, {6, 3}}, {{6, 3}, {6, 7}}, {{6, 7}, {2, 7}}}}.space();
  const Journey j = travel(pocket, {4, 5}, {9, 5}, sees(kInfinity));
  ASSERT_TRUE(j.reached);
  ASSERT_EQ(j.minima.size(), 1U);
  EXPECT_EQ(j.minima[0].at, (Point{4, 5}));
  EXPECT_THAT(j.path.points, ElementsAre(Point{4, 5}, Point{2, 7}, Point{6, 7}, Point{9, 5}));
  EXPECT_EQ(j.path.length, shortest_path(pocket, {4, 5}, {9, 5})->length);
}

//       |   +-+ from the wall's upper end the box is nearer to the goal than the wall, but out of range: the robot
//           leaves
//   S   |   +-+  G   where it only has to touch, on the far side of the wall
//       |
TEST(TangentBug, LeavesForCornersWithinItsRangeOnly) {
  const FreeSpace space = SmallWorld{.walls = {{{4, 2}, {4, 8}}}, .solids = {box_ring(6, 7.5, 7, 8.5)}}.space();
  const Journey near = travel(space, {1, 5}, {9, 5}, sees(0.5));
  ASSERT_EQ(near.leaves.size(), 1U);
  EXPECT_EQ(near.leaves[0].at, (Point{4, 5}));
  const Journey far = travel(space, {1, 5}, {9, 5}, sees(2.5));
  ASSERT_EQ(far.leaves.size(), 1U);
  EXPECT_EQ(far.leaves[0].at, (Point{4, 8}));
}

// A convex polygon with corners on a circle. The rule has no memory: at its first corner the robot may find the other
// way round more promising, and turn back.
TEST(TangentBug, IsTautAroundAConvexObstacleUnlessItTurnsBack) {
  int turned_back = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    taut::Draws draws(seed);
    std::vector<double> angles(3 + draws.below(9));
    for (double& a : angles) a = draws.unit() * 2 * std::numbers::pi;
    std::sort(angles.begin(), angles.end());
    Ring ring;
    for (const double a : angles) ring.push_back({5 + 3 * std::cos(a), 5 + 3 * std::sin(a)});
    const FreeSpace space = SmallWorld{.solids = {ring}}.space();
    const Point from{1, 1 + 8 * draws.unit()}, to{9, 1 + 8 * draws.unit()};
    const Journey j = travel(space, from, to, sees(kInfinity));
    ASSERT_TRUE(j.reached) << seed;
    EXPECT_TRUE(j.minima.empty()) << seed;
    turned_back += j.path.length != shortened(space, j.path)->length;
  }
  EXPECT_LE(turned_back, 2);
}

double area(const Ring& ring) { return ring_area(ring) / 2; }

// The second opinion is FreeSpace's own view, from an origin in doubles, with another reckoning of ends.
TEST(TangentBug, SeesWhatIsVisibleAndNothingBeyondItsRange) {
  int views = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const test::MessyWorld messy = test::messy_world(seed);
    const FreeSpace space(World(messy.parts), messy.footprint);
    taut::Draws draws(seed);
    const double x = draws.unit() * 10, y = draws.unit() * 10;
    const Point from{x, y}, to{10 - x, 10 - y};
    if (space.locate(from).kind != Location::Kind::triangle || space.locate(to).kind == Location::Kind::outside)
      continue;
    const Journey all = travel(space, from, to, sees(kInfinity));
    if (all.views.empty()) continue;
    EXPECT_NEAR(area(all.views[0].ring), area(space.visibility_polygon(from).ring), 1e-6) << seed;
    const Journey some = travel(space, from, to, sees(2));
    for (const View& view : some.views) {
      const Point at = some.path.points[view.point];
      EXPECT_LE(area(view.ring), 4 * std::numbers::pi + 1e-9) << seed;
      for (const Point p : view.ring) EXPECT_LE(std::hypot(p.x - at.x, p.y - at.y), 2 + 1e-6) << seed;
      ++views;
    }
  }
  EXPECT_GT(views, 100);
}

// Something is built where the robot never looked: it walks the same way.
TEST(TangentBug, TakesNoNoticeOfWhatItDoesNotSee) {
  constexpr double kRange = 1, kSide = 0.25;
  int built = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    test::MessyWorld messy = test::messy_world(seed);
    messy.footprint = Footprint::point();
    const FreeSpace space(World(messy.parts), messy.footprint);
    taut::Draws draws(seed);
    const auto place = [&] {
      const double x = draws.unit() * 9, y = draws.unit() * 9;
      return Point{x, y};
    };
    const Point from = place(), to = place(), corner = place();
    const auto is_free = [&](Point p) { return space.locate(p).kind == Location::Kind::triangle; };
    const Point middle{corner.x + kSide / 2, corner.y + kSide / 2};
    if (!is_free(from) || !is_free(to) || !is_free(middle) || space.clearance(middle).distance < kSide) continue;
    const Journey before = travel(space, from, to, sees(kRange));
    double nearest = kInfinity;
    for (std::size_t i = 1; i < before.path.points.size(); ++i) {
      const Point foot = [&] {
        const bug::detail::ExactPoint p =
            bug::detail::nearest_on(before.path.points[i - 1], before.path.points[i], bug::detail::ExactPoint(middle));
        return Point{to_double(p.x), to_double(p.y)};
      }();
      nearest = std::min(nearest, std::hypot(foot.x - middle.x, foot.y - middle.y));
    }
    if (nearest < kRange + kSide) continue;
    ++built;
    messy.parts.solids.push_back({Polygon{box_ring(corner.x, corner.y, corner.x + kSide, corner.y + kSide), {}}, 0});
    const Journey after = travel(FreeSpace(World(messy.parts), messy.footprint), from, to, sees(kRange));
    EXPECT_EQ(after.path.points, before.path.points) << seed;
  }
  EXPECT_GT(built, 50);
}

TEST(TangentBug, ComparesSumsOfRootsExactly) {
  using bug::detail::compare_roots;
  EXPECT_EQ(compare_roots(2, 8, 18, 0), 0);
  EXPECT_EQ(compare_roots(3, 12, 27, 0), 0);
  EXPECT_EQ(compare_roots(0, 0, 0, 0), 0);
  EXPECT_EQ(compare_roots(5, 0, 0, 5), 0);
  const Rational tiny = Rational(1) / Rational("1000000000000000000000000000000000000000000");
  EXPECT_EQ(compare_roots(Rational(2 + tiny), 8, 18, 0), 1);
  EXPECT_EQ(compare_roots(2, 8, Rational(18 + tiny), 0), -1);
  EXPECT_EQ(compare_roots(1, 9, 4, 4), 0);
  EXPECT_EQ(compare_roots(1, 8, 4, 4), -1);
}

}  // namespace
}  // namespace taut::bug
