// The earliest meeting with a target in the plane, beside the shortest paths to many of its places.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include <taut/geometry/exact/exact_point.h>
#include <taut/robots/pursuit/interception.h>
#include <taut/search/polyanya.h>

#include "support/random_world.h"

namespace taut::pursuit {
namespace {

using test::box_ring;
using test::SmallWorld;

std::optional<MeetingPlace> meeting(const SmallWorld& world, Point start, double speed, std::vector<TimedPoint> way,
                                    bool stays = false) {
  return earliest_meeting(VisibilityGraph(world.space()), {start, speed, std::move(way), stays});
}

/// In doubles, by the navigation mesh: how far the target is at a time.
class SecondOpinion {
 public:
  SecondOpinion(const FreeSpace& space, Point start) : space_(space), search_(Polyanya(space)), start_(start) {}

  /// Nothing at walls: a place on one belongs to both its sides, its rounding to one or to none.
  std::optional<double> distance(Point to) {
    if (!space_.holds(to) || space_.clearance(to).distance < 1e-9) return std::nullopt;
    return search_.find(start_, to) == SearchStatus::found ? search_.length() : std::numeric_limits<double>::infinity();
  }

 private:
  FreeSpace space_;
  PolyanyaSearch search_;
  Point start_;
};

TEST(Interception, MeetsHeadOn) {
  const auto found = meeting({}, {0, 5}, 1, {{0, {10, 5}}, {10, {0, 5}}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->time, Interval(5, 5));
  EXPECT_EQ(found->at, (Point{5, 5}));
  EXPECT_EQ(found->path, (std::vector<Point>{{0, 5}, {5, 5}}));
  EXPECT_EQ(found->waits, 0);
}

TEST(Interception, EnclosesAnIrrationalTimeByNeighbouringDoubles) {
  // From (0, 0) to a target that climbs from (1, 0) with speed 1/2: sqrt(1 + t^2 / 4) = t, t = 2 / sqrt(3).
  const auto found = meeting({}, {0, 0}, 1, {{0, {1, 0}}, {20, {1, 10}}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->time.lo, 2 / std::sqrt(3.0), 1e-15);
  EXPECT_EQ(found->time.hi, std::nextafter(found->time.lo, 10));
  EXPECT_LT(3 * Rational(found->time.lo) * Rational(found->time.lo), 4);
  EXPECT_GT(3 * Rational(found->time.hi) * Rational(found->time.hi), 4);
}

TEST(Interception, GoesAroundAWall) {
  // Up to (5, 4) and down again, sqrt(32) each, to a target that stands.
  const auto found = meeting({.walls = {{{5, 0}, {5, 4}}}}, {1, 0}, 1, {{0, {9, 0}}, {1, {9, 0}}}, true);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->time.hi, 2 * std::sqrt(32.0), 1e-12);
  EXPECT_EQ(found->path, (std::vector<Point>{{1, 0}, {5, 4}, {9, 0}}));
}

TEST(Interception, WaitsForATargetThatComesLater) {
  const auto found = meeting({}, {0, 0}, 1, {{10, {3, 4}}, {12, {9, 4}}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->time, Interval(10, 10));
  EXPECT_EQ(found->at, (Point{3, 4}));
  EXPECT_DOUBLE_EQ(found->waits, 5);
}

TEST(Interception, IsNoneWhenTheWayEndsTooEarly) {
  EXPECT_FALSE(meeting({}, {0, 0}, 1, {{0, {5, 0}}, {2, {7, 0}}}));
  EXPECT_TRUE(meeting({}, {0, 0}, 1, {{0, {5, 0}}, {2, {7, 0}}}, true));
  // Just in time, at the last instant.
  EXPECT_EQ(meeting({}, {0, 0}, 1, {{0, {5, 0}}, {7, {7, 0}}})->time, Interval(7, 7));
}

TEST(Interception, IsNoneBehindWalls) {
  const SmallWorld world{.solids = {box_ring(4, 0, 5, 10)}};
  EXPECT_FALSE(meeting(world, {1, 1}, 100, {{0, {8, 1}}, {100, {8, 9}}}, true));
}

TEST(Interception, SeizesTheOneInstantOfAFasterTarget) {
  // With speed 5/4 along y = 3 from x = -15/4 at 0: it touches the cone of a robot with speed 1 in one instant only.
  // sqrt(9 + (5t/4 + x0)^2) = t has a double root where x0 = -9/4: t = 5.
  const auto touched = meeting({.area = box_ring(-20, -20, 90, 20)}, {0, 0}, 1, {{0, {-2.25, 3}}, {40, {47.75, 3}}});
  ASSERT_TRUE(touched);
  EXPECT_EQ(touched->time, Interval(5, 5));
  EXPECT_EQ(touched->at, (Point{4, 3}));
  const auto missed = meeting({.area = box_ring(-20, -20, 90, 20)}, {0, 0}, 1, {{0, {-2.2499, 3}}, {40, {47.7501, 3}}});
  EXPECT_FALSE(missed);
  const auto twice = meeting({.area = box_ring(-20, -20, 90, 20)}, {0, 0}, 1, {{0, {-2.2501, 3}}, {40, {47.7499, 3}}});
  ASSERT_TRUE(twice);
  EXPECT_LT(twice->time.hi, 5);
}

TEST(Interception, DecidesAnInstantBehindABendByRoots) {
  // The same with the robot behind a bend at the origin, and the target later by the time that it takes to get there.
  const auto after = [](Point start, double late) {
    return meeting({.walls = {{{0, 0}, {0, -20}}}, .area = box_ring(-20, -20, 90, 20)}, start, 1,
                   {{late, {-2.25, 3}}, {late + 40, {47.75, 3}}});
  };
  const auto touched = after({-3, -4}, 5);
  ASSERT_TRUE(touched);
  EXPECT_EQ(touched->time, Interval(10, 10));
  EXPECT_EQ(touched->path, (std::vector<Point>{{-3, -4}, {0, 0}, {4, 3}}));
  // sqrt(2) from above and from below, in 15 digits.
  EXPECT_FALSE(after({-1, -1}, 1.41421356237309));
  EXPECT_TRUE(after({-1, -1}, 1.4142135623731));
}

TEST(Interception, MeansDecimals) {
  // 0.7 ahead at 0.1 of speed is 7, though the doubles say something else.
  const auto found = meeting({.area = box_ring(0, 0, 2, 2)}, {0.1, 0.3}, 0.1, {{0, {0.8, 0.3}}, {9, {0.8, 0.3}}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->time, Interval(7, 7));
}

TEST(Interception, SaysWhichLegIsBlocked) {
  const FreeSpace space = SmallWorld{.walls = {{{5, 0}, {5, 4}}}}.space();
  const std::vector<TimedPoint> way{{0, {1, 1}}, {1, {2, 1}}, {2, {8, 1}}};
  EXPECT_EQ(blocked_leg(space, way), 1U);
  EXPECT_EQ(blocked_leg(space, std::span(way).first(2)), std::nullopt);
  EXPECT_EQ(blocked_leg(space, std::vector<TimedPoint>{{0, {11, 1}}}), 0U);
}

/// A way of straight legs that can be walked, at times that make the target slow, fast or stand.
std::vector<TimedPoint> any_way(const FreeSpace& space, int side) {
  std::vector<TimedPoint> way;
  double time = test::any(0, 3);
  for (int tries = 0; tries < 40 && way.size() < 5; ++tries) {
    const Point p = test::any(0, 1) ? test::any_lattice_point(side) : test::any_fine_point(side);
    if (!space.holds(p) || (!way.empty() && !space.sees(way.back().at, p))) continue;
    way.push_back({time, p});
    time += test::any(1, 16) / 4.0;
  }
  return way;
}

RC_GTEST_PROP(Interception, IsWhereSampledShortestPathsSayItIs, ()) {
  const test::RandomWorld kind{.side = 6, .walls = 6, .solids = 2};
  const SmallWorld world = test::any_world(kind);
  const FreeSpace space = world.space();
  const Point start = test::any(0, 3) ? test::any_fine_point(kind.side) : test::any_lattice_point(kind.side);
  const std::vector<TimedPoint> way = any_way(space, kind.side);
  RC_PRE(space.holds(start) && !way.empty());
  const double speed = test::any(1, 12) / 4.0;
  const bool stays = test::any(0, 2) == 0;
  RC_LOG() << test::show(world) << " from " << test::show(start) << " at " << speed << (stays ? ", stays" : "");
  for (const TimedPoint& p : way) RC_LOG() << "; " << p.time << ": " << test::show(p.at);
  const auto found = earliest_meeting(VisibilityGraph(space), {start, speed, way, stays});
  SecondOpinion opinion(space, start);
  if (found) {
    const std::optional<double> d = opinion.distance(found->at);
    RC_ASSERT(found->time.hi >= way.front().time);
    if (d && found->waits == 0) RC_ASSERT(std::abs(*d - speed * found->time.hi) < 1e-9);
    if (d) RC_ASSERT(*d <= speed * found->time.hi + 1e-9);
    const Point at = place_at(way, found->time.hi);
    RC_ASSERT(std::hypot(at.x - found->at.x, at.y - found->at.y) < 1e-9);
  }
  const double end = stays ? way.back().time + 20 : way.back().time;
  const double until = found ? found->time.lo : end;
  for (int i = 0; i <= 60; ++i) {
    const double t = way.front().time + (until - way.front().time) * i / 60;
    if (t >= until && found) break;
    const std::optional<double> d = opinion.distance(place_at(way, t));
    if (d) RC_ASSERT(*d > speed * t - 1e-9);
  }
}

}  // namespace
}  // namespace taut::pursuit
