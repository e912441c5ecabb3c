#include <taut/roadmaps/disc_places.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include <taut/search/disc_passage.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::box_ring;
using test::SmallWorld;

FreePlace nearest(const FreeSpace& space, double r, Point p) {
  const DiscPlaces places(space, r);
  const auto place = places.nearest(p);
  EXPECT_TRUE(place.has_value());
  EXPECT_TRUE(places.is_free(place->point));
  return *place;
}

TEST(DiscPlaces, TouchWallsButAreNotNearer) {
  const DiscPlaces places(SmallWorld{.walls = {{{2, 5}, {8, 5}}}}.space(), 0.35);
  EXPECT_TRUE(places.is_free({3, 5.35}));
  EXPECT_FALSE(places.is_free({3, 5.349}));
  EXPECT_TRUE(places.is_free({8.21, 5.28})) << "0.21^2 + 0.28^2 is 0.35^2, of decimals";
  EXPECT_FALSE(places.is_free({8.21, 5.2799999}));
  EXPECT_TRUE(places.is_free({0, 1})) << "one may stand on an opening";
  EXPECT_FALSE(places.is_free({-0.1, 1}));
}

TEST(DiscPlaces, NearestIsBesideTheWallByTheTrueRadius) {
  const FreePlace place = nearest(SmallWorld{.walls = {{{2, 5}, {8, 5}}}}.space(), 0.35, {3.1, 5.1});
  EXPECT_EQ(place.point, (Point{3.1, 5.35}));
  EXPECT_DOUBLE_EQ(place.distance, 0.25);
  EXPECT_LT(place.rounding, 1e-15);
}

TEST(DiscPlaces, NearestIsOnTheCircleAroundAWallsEnd) {
  const FreePlace place = nearest(SmallWorld{.walls = {{{2, 5}, {8, 5}}}}.space(), 0.35, {8.03, 5.04});
  EXPECT_NEAR(place.point.x, 8.21, 1e-13);
  EXPECT_NEAR(place.point.y, 5.28, 1e-13);
  EXPECT_NEAR(place.distance, 0.3, 1e-13);
}

TEST(DiscPlaces, NearestIsWhereTwoOutlinesCross) {
  // In the corner of two walls the foot beside the one is too near to the other.
  const FreePlace corner = nearest(SmallWorld{.walls = {{{0, 5}, {8, 5}}, {{8, 5}, {8, 0}}}}.space(), 1, {7.9, 4.8});
  EXPECT_EQ(corner.point, (Point{9, 4.8})) << "on the other side of the wall: 1.1 is less than 1.2";
  const FreePlace inner = nearest(SmallWorld{.walls = {{{0, 5}, {8, 5}}, {{8, 9}, {8, 0}}}}.space(), 1.5, {7.5, 5.5});
  EXPECT_EQ(inner.point, (Point{6.5, 6.5}));
  // Between two posts, below their line: where the circles around them cross.
  const FreePlace posts = nearest(SmallWorld{.walls = {{{4, 9}, {4, 5}}, {{5.2, 9}, {5.2, 5}}}}.space(), 1, {4.6, 4.9});
  EXPECT_NEAR(posts.point.x, 4.6, 1e-12);
  EXPECT_NEAR(posts.point.y, 4.2, 1e-12);
}

TEST(DiscPlaces, NearestFindsTheMiddleOfAGapAsWideAsTheDisc) {
  const FreePlace place =
      nearest(SmallWorld{.walls = {{{0, 2}, {10, 2}}, {{0, 2.7}, {10, 2.7}}}}.space(), 0.35, {5.3, 2.6});
  EXPECT_EQ(place.point, (Point{5.3, 2.35}));
}

TEST(DiscPlaces, NearestIsFarWhereWallsAreDense) {
  SmallWorld world{.area = box_ring(-20, -20, 30, 30)};
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j) world.walls.push_back({{double(i), double(j)}, {i + 0.5, j + 0.5}});
  const FreePlace place = nearest(world.space(), 2, {4.9, 5.1});
  EXPECT_NEAR(place.distance, 6.9, 0.1);
}

TEST(DiscPlaces, AreAbsentInARoomThatIsTooSmall) {
  const DiscPlaces places(FreeSpace(SmallWorld{.area = box_ring(0, 0, 3, 3)}.bounded(Boundary::walled)), 1.6);
  EXPECT_FALSE(places.nearest({1, 1}));
}

/// By doubles alone: the least distance to what was drawn.
double clearance(const SmallWorld& world, Point p) {
  double least = HUGE_VAL;
  const auto add = [&](Point a, Point b) {
    const double ux = b.x - a.x, uy = b.y - a.y, uu = ux * ux + uy * uy;
    const double t = uu > 0 ? std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / uu, 0.0, 1.0) : 0;
    least = std::min(least, std::hypot(p.x - a.x - t * ux, p.y - a.y - t * uy));
  };
  for (const Segment& s : world.walls)
    if (s.a != s.b) add(s.a, s.b);
  for (const Ring& ring : world.solids)
    for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
  return least;
}

RC_GTEST_PROP(DiscPlaces, NearestIsFreeAndNothingFreeIsNearer, ()) {
  const test::RandomWorld kind{.side = 8, .walls = 5, .solids = 2};
  const SmallWorld world = test::any_world(kind);
  const FreeSpace space = FreeSpace(world.bounded(Boundary::open));
  const double r = test::any(1, 15) / 10.0;
  const DiscPlaces places(space, r);
  for (int n = 0; n < 3; ++n) {
    const Point p = test::any_fine_point(kind.side);
    const auto place = places.nearest(p);
    if (place) {
      RC_ASSERT(space.locate(place->point).kind != Location::Kind::outside);
      RC_ASSERT(clearance(world, place->point) >= r - 1e-12);
      if (place->rounding >= 1e-9)
        RC_LOG() << test::show(world) << r << ' ' << test::show(p) << test::show(place->point) << place->distance << ' '
                 << place->rounding << std::endl;
      RC_ASSERT(place->rounding < 1e-9);
    }
    for (double x = 0; x <= kind.side; x += 0.0625)
      for (double y = 0; y <= kind.side; y += 0.0625) {
        const Point q{x, y};
        if (space.locate(q).kind == Location::Kind::outside || clearance(world, q) < r + 1e-9) continue;
        RC_ASSERT(place.has_value());
        RC_ASSERT(std::hypot(x - p.x, y - p.y) >= place->distance - place->rounding - 1e-12);
      }
  }
}

RC_GTEST_PROP(DiscPlaces, IsFreeWhereTheGatesSayThatTheDiscCanStand, ()) {
  const test::RandomWorld kind{.side = 6, .walls = 6, .solids = 1};
  const FreeSpace space(World(test::any_world(kind).parts()));
  const double r = test::any(1, 10) / 10.0;
  const DiscPlaces places(space, r);
  const Gates gates(space);
  for (int n = 0; n < 20; ++n) {
    const Point p = test::any_fine_point(kind.side);
    RC_ASSERT(places.is_free(p) == (disc_passage(gates, p, p, r).status != DiscStatus::start_blocked));
  }
}

}  // namespace
}  // namespace taut
