#include <taut/geometry/nearest_free.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "support/messy_world.h"
#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::box_ring;
using test::SmallWorld;

bool is_free(const FreeSpace& space, Point p) { return space.locate(p).kind != Location::Kind::outside; }

TEST(NearestFree, IsThePointItselfWhereTheRobotCanBe) {
  const FreeSpace space = SmallWorld{.solids = {box_ring(2, 2, 5, 8)}}.space();
  for (const Point p : {Point{1, 1}, {2, 3}, {2, 2}, {10, 10}}) {
    const auto place = nearest_free(space, p);
    ASSERT_TRUE(place);
    EXPECT_EQ(place->point, p);
    EXPECT_EQ(place->distance, 0);
    EXPECT_EQ(place->rounding, 0);
  }
}

TEST(NearestFree, IsTheFootOnTheNearestSideExactlyWhereThatIsADecimal) {
  const FreeSpace space = SmallWorld{.solids = {box_ring(2, 2, 5, 8)}}.space();
  const auto place = nearest_free(space, {2.1, 3.3});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->point, (Point{2, 3.3}));
  EXPECT_EQ(place->distance, 0.1) << "of what was written, not of doubles";
  EXPECT_EQ(place->rounding, 0);
}

TEST(NearestFree, OfAPointOutsideTheWorldIsOnItsOutline) {
  const FreeSpace space = SmallWorld{}.space();
  EXPECT_EQ(nearest_free(space, {3.5, -2})->point, (Point{3.5, 0}));
  EXPECT_EQ(nearest_free(space, {13, 14})->point, (Point{10, 10}));
  EXPECT_EQ(nearest_free(space, {13, 14})->distance, 5);
}

TEST(NearestFree, IsBesideASlopedSideAndSaysHowFar) {
  const FreeSpace space = SmallWorld{.solids = {{{1, 1}, {8, 4}, {1, 9}}}}.space();
  const auto place = nearest_free(space, {3, 2.5});
  ASSERT_TRUE(place);
  EXPECT_TRUE(is_free(space, place->point));
  EXPECT_GT(place->rounding, 0);
  EXPECT_LT(place->rounding, 1e-13);
  EXPECT_NEAR(place->distance, std::abs(3 * 2 - 7 * 1.5) / std::sqrt(58), 1e-12);
}

TEST(NearestFree, IsAbsentWhereTheRobotFitsNowhere) {
  const FreeSpace space(SmallWorld{.area = box_ring(0, 0, 3, 3)}.bounded(Boundary::walled), Footprint::square(2));
  EXPECT_FALSE(nearest_free(space, {1, 1}));
}

TEST(NearestFree, OfASquareKeepsItsHalfSide) {
  const FreeSpace space(SmallWorld{.walls = {{{2, 5}, {8, 5}}}}.bounded(Boundary::walled), Footprint::square(0.35));
  EXPECT_EQ(nearest_free(space, {3.1, 5.1})->point, (Point{3.1, 5.35}));
  EXPECT_EQ(nearest_free(space, {3.1, 0.1})->point, (Point{3.1, 0.35}));
}

TEST(NearestObstacle, IsTheWallThatIsNearNotOneOfManyThatAreFar) {
  SmallWorld world{.walls = {{{9, 9}, {9, 0}}}, .thickness = 0.2};
  world.solids = {box_ring(6, 4, 7, 5), box_ring(1, 1, 2, 2)};
  const World w(world.parts());
  EXPECT_EQ(text(nearest_obstacle(w, {6.5, 3.5})), "the obstacle with the side from (6, 4) to (7, 4)");
  EXPECT_EQ(text(nearest_obstacle(w, {8.5, 3.5})), "the wall from (9, 9) to (9, 0)");
  EXPECT_NEAR(nearest_obstacle(w, {8.5, 3.5}).distance, 0.4, 1e-12);
  EXPECT_EQ(text(nearest_obstacle(w, {5, -1})), "the outline from (0, 0) to (10, 0)");
}

TEST(NearestObstacle, CountsOutlinesOfFloorPlansOnly) {
  const SmallWorld world{.walls = {{{5, 5}, {6, 5}}}};
  EXPECT_EQ(nearest_obstacle(world.bounded(Boundary::walled), {0.1, 5}).kind, NearObstacle::Kind::outline);
  EXPECT_EQ(nearest_obstacle(world.bounded(Boundary::limit), {0.1, 5}).kind, NearObstacle::Kind::wall);
}

TEST(NearestObstacle, IsTheOneThatThePointIsDeepestIn) {
  SmallWorld world{.walls = {{{2, 5}, {8, 5}}, {{5, 5.4}, {6, 5.4}}}, .thickness = 1};
  EXPECT_EQ(nearest_obstacle(World(world.parts()), {5.5, 5.1}).index, 0u);
  EXPECT_EQ(nearest_obstacle(World(world.parts()), {5.5, 5.3}).index, 1u);
}

/// No free point of a fine lattice, and none along the outline of what is free, is nearer.
void expect_nearest(const FreeSpace& space, Point p, double side) {
  const auto place = nearest_free(space, p);
  const auto expect_not_nearer = [&](Point q) {
    RC_ASSERT(place.has_value());
    RC_ASSERT(std::hypot(q.x - p.x, q.y - p.y) >= place->distance - place->rounding - 1e-12);
  };
  if (place) RC_ASSERT(is_free(space, place->point));
  constexpr int kSteps = 40;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j)
      if (const Point q{side * i / kSteps, side * j / kSteps}; is_free(space, q)) expect_not_nearer(q);
  for (const Constraint& c : space.constraints())
    for (int k = 0; k <= kSteps; ++k) {
      const double t = double(k) / kSteps;
      expect_not_nearer({c.a.x + t * (c.b.x - c.a.x), c.a.y + t * (c.b.y - c.a.y)});
    }
}

RC_GTEST_PROP(NearestFree, IsFreeAndNoFreePointIsNearer, ()) {
  const test::RandomWorld kind{.thickness = test::any(0, 1) * 0.3};
  const FreeSpace space(World(test::any_world(kind).parts()));
  for (int n = 0; n < 4; ++n) {
    const Point p = test::any_fine_point(kind.side + 2);
    expect_nearest(space, {p.x - 1, p.y - 1}, kind.side);
  }
}

RC_GTEST_PROP(NearestFree, HoldsForRobotsAndWorldsOffEveryLattice, (std::uint64_t seed)) {
  const test::MessyWorld world = test::messy_world(seed);
  const FreeSpace space(World(world.parts), world.footprint);
  for (int n = 0; n < 4; ++n) {
    const Point p = test::any_fine_point(12);
    expect_nearest(space, {p.x - 1, p.y - 1}, 10);
  }
}

}  // namespace
}  // namespace taut
