// What nearly touches is seen, and joined within a tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <support/refusal.h>
#include <support/small_world.h>
#include <support/turned.h>
#include <taut/geometry/snap.h>
#include <taut/search/shortest_path.h>

namespace taut {
namespace {

using test::box_ring;
using test::refusal_of;
using test::SmallWorld;
using test::Turn;

constexpr Snap kRounding{}, kAuto{Snap::What::automatic};

/// A wall across the box, and one that should stand on it: its end lies `gap` above.
World t_junction(double gap) {
  return World(SmallWorld{.walls = {{{0, 4}, {10, 4}}, {{5, 4 + gap}, {5, 10}}}}.parts());
}

bool leaks(const World& world) { return shortest_path(FreeSpace(world), {4, 8}, Point{6, 8}).has_value(); }

TEST(Snapped, JoinsAnEndToTheWallThatItNearlyTouches) {
  const World world = t_junction(0.001);
  ASSERT_TRUE(leaks(world));
  const Snapped joined = snapped(world, 0.001);
  EXPECT_FALSE(leaks(joined.world));
  EXPECT_EQ(joined.report.joined, 1U);
  EXPECT_DOUBLE_EQ(joined.report.displacement, 0.001);
  EXPECT_TRUE(joined.report.remaining.empty());
  EXPECT_EQ(joined.world.walls().size(), 3U);
}

TEST(Snapped, LeavesWhatIsFartherApartThanTheTolerance) {
  EXPECT_TRUE(leaks(snapped(t_junction(0.001), 0.000999).world));
  EXPECT_EQ(snapped(t_junction(0.001), 0.000999).report.joined, 0U);
}

TEST(Snapped, JoinsEndsToOnePoint) {
  // The third corner of a triangle was clicked twice.
  const World world(SmallWorld{.walls = {{{1, 1}, {9, 1}}, {{9, 1}, {5, 8}}, {{4.99, 8}, {1, 1}}}}.parts());
  ASSERT_TRUE(shortest_path(FreeSpace(world), {5, 3}, Point{5, 9}));
  const Snapped joined = snapped(world, 0.01);
  EXPECT_FALSE(shortest_path(FreeSpace(joined.world), {5, 3}, Point{5, 9}));
  EXPECT_EQ(joined.world.walls().size(), 3U);
}

TEST(Snapped, MakesOneOfWallsThatNearlyCoincide) {
  const World world(SmallWorld{.walls = {{{1, 1}, {9, 3}}, {{1, 1.0001}, {9, 2.9999}}, {{3, 1.5001}, {12.9999, 4}}},
                               .area = box_ring(0, 0, 20, 20)}
                        .parts());
  const Snapped joined = snapped(world, 0.001);
  EXPECT_EQ(FreeSpace(joined.world).report().crossings, 0U);
  EXPECT_EQ(FreeSpace(joined.world).report().displacement, 0);
  EXPECT_TRUE(joined.report.remaining.empty());
}

TEST(Snapped, LeavesATrueGapOfOneUlpOpenWhenNothingIsToBeJoined) {
  const double ulp = std::nextafter(4.0, 5.0) - 4;
  ASSERT_TRUE(leaks(t_junction(ulp)));
  EXPECT_TRUE(leaks(snapped(t_junction(ulp), 0).world));
  EXPECT_FALSE(leaks(snapped(t_junction(ulp), kRounding).world));
}

TEST(Snapped, LeavesWrittenNumbersAsTheyAreByDefault) {
  // Gaps of 1e-14: within rounding of a box of 10, but somebody wrote them.
  EXPECT_TRUE(leaks(snapped(t_junction(0.00000000000001), kRounding).world));
  const Snapped same = snapped(t_junction(0.001), kRounding);
  EXPECT_EQ(same.report.joined, 0U);
  EXPECT_EQ(same.world.uncertainty(), 0);
}

TEST(Snapped, MovesNothingFartherThanTheTolerance) {
  std::mt19937 engine(7);
  const auto draw = [&](double scale) { return scale * static_cast<double>(engine() % 10000) / 10000; };
  const auto distance = [](Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
  };
  for (int round = 0; round < 50; ++round) {
    SmallWorld small;
    for (int i = 0; i < 60; ++i) {
      const Point a{draw(10), draw(10)};
      small.walls.push_back({a, {a.x + draw(4) - 2, a.y + draw(4) - 2}});
    }
    small.area = box_ring(-3, -3, 13, 13);
    WorldParts parts = small.parts();
    for (std::size_t i = 0; i < parts.walls.size(); ++i) parts.walls[i].line = static_cast<int>(i + 1);
    const double tolerance = 0.05;
    const SnappedParts joined = snapped(parts, Snap{Snap::What::within, tolerance});
    EXPECT_LE(joined.report.displacement, tolerance);
    EXPECT_GT(joined.report.joined, 0U);
    for (const Wall& piece : joined.parts.walls) {
      const Wall& own = parts.walls[static_cast<std::size_t>(piece.line) - 1];
      EXPECT_LE(distance(piece.a, own.a, own.b), tolerance * 1.000001);
      EXPECT_LE(distance(piece.b, own.a, own.b), tolerance * 1.000001);
    }
  }
}

TEST(Snapped, KeepsBothEndsOfAShortWallAndRefusesWhatRemains) {
  const World world(SmallWorld{.walls = {{{1, 1}, {1.01, 1}}, {{3, 3}, {4, 3}}, {{3, 3.02}, {4, 3.05}}}}.parts());
  const Snapped joined = snapped(world, 0.03);
  EXPECT_EQ(joined.world.walls().front().b, (Point{1.01, 1}));
  // The ends of four walls in a row cannot come to one point.
  const WorldParts parts =
      SmallWorld{.walls = {{{5, 1}, {5, 9}}, {{5.03, 1}, {5.03, 0}}, {{5.06, 1}, {5.06, 9}}, {{5.09, 1}, {5.09, 0}}}}
          .parts();
  EXPECT_FALSE(snapped(World(parts), 0.04).report.remaining.empty());
  EXPECT_NE(refusal_of([&] {
              snapped_world(parts, Snap{Snap::What::within, 0.04});
            }).find("leaves contacts"),
            std::string::npos);
  EXPECT_EQ(refusal_of([&] { snapped_world(parts, kAuto); }), "accepted");
}

TEST(Snapped, LeavesThickWallsThatCoverTheGap) {
  WorldParts parts = t_junction(0.001).parts();
  for (Wall& wall : parts.walls) wall.thickness = 0.1;
  EXPECT_EQ(snapped(World(parts), 0.01).report.joined, 0U);
}

TEST(Snapped, LetsAWallPassThroughAStartWithinRoundingOfIt) {
  const Turn turn(33);
  WorldParts parts = turn(SmallWorld{.walls = {{{1, 2}, {9, 2}}}}.parts());
  parts.start = turn({4, 2});
  parts.goal.point = turn({4, 0});
  const World world = snapped_world(parts).world;
  // On the wall it may leave to both sides.
  EXPECT_NEAR(shortest_path(FreeSpace(world), *world.start(), turn({4, 0}))->length.value(), 2, 1e-12);
  EXPECT_NEAR(shortest_path(FreeSpace(world), *world.start(), turn({4, 4}))->length.value(), 2, 1e-12);
  EXPECT_EQ(*world.start(), turn({4, 2}));
}

TEST(Snapped, LetsASideOfTheOutlinePassThroughAnEndWithinRoundingOfIt) {
  int outside = 0;
  for (int degrees = 1; degrees < 90; ++degrees) {
    const Turn turn(degrees);
    WorldParts parts = turn(SmallWorld{}.parts());
    parts.start = turn({10, 4});
    parts.goal.point = turn({0, 7});
    outside += FreeSpace(World(parts)).locate(*parts.start).kind == Location::Kind::outside;
    const World world = snapped_world(parts).world;
    EXPECT_NE(FreeSpace(world).locate(*world.start()).kind, Location::Kind::outside);
    EXPECT_NE(FreeSpace(world).locate(*world.goal().point).kind, Location::Kind::outside);
  }
  EXPECT_GT(outside, 10);
}

TEST(Snapped, DoesNotRefuseARingForHavingBeenJoined) {
  // A neck one ulp wide: joined, the ring would pinch itself.
  const double ulp = std::nextafter(5.0, 6.0) - 5;
  const Ring ring{{0, 0}, {10, 0}, {10, 10}, {5 + ulp, 5}, {9, 1}, {1, 1}, {5, 5}, {0, 10}};
  WorldParts parts = SmallWorld{.area = ring}.parts();
  EXPECT_EQ(refusal_of([&] { World world(parts); }), "accepted");
  EXPECT_EQ(refusal_of([&] { snapped_world(parts); }), "accepted");
}

TEST(Snapped, HasNothingLeftToJoinWhenItIsAskedAgain) {
  const World maze =
      World(Turn(17)(SmallWorld{.walls = {{{0, 4}, {10, 4}}, {{5, 4}, {5, 10}}, {{7, 4}, {7, 0}}}}.parts()));
  const Snapped once = snapped(maze, kRounding);
  EXPECT_GT(once.report.joined, 0U);
  EXPECT_EQ(snapped(once.world, kRounding).report.joined, 0U);
}

TEST(AutoTolerance, IsTheDistanceBelowTheGreatestGap) {
  EXPECT_DOUBLE_EQ(auto_tolerance(t_junction(0.001).parts()), 0.001);
  EXPECT_DOUBLE_EQ(snapped(t_junction(0.001), kAuto).report.displacement, 0.001);
}

TEST(AutoTolerance, IsNoneWhereDistancesLeaveNoGap) {
  SmallWorld world{.walls = {{{0, 4}, {10, 4}}}};
  double x = 0.5;
  for (double gap = 0.002; gap < 12; gap *= 5, ++x) world.walls.push_back({{x, 4 + std::min(gap, 5.5)}, {x, 9.9}});
  EXPECT_EQ(auto_tolerance(World(world.parts()).parts()), 0);
}

TEST(AutoTolerance, IsNoneAboveAThousandthOfTheExtent) { EXPECT_EQ(auto_tolerance(t_junction(0.011).parts()), 0); }

TEST(NearContacts, AreEndsThatSomebodyRounded) {
  // Millimetres on a wall of 10 m: the end is within one of them of the sloped wall.
  const World world(SmallWorld{.walls = {{{0, 1}, {10, 4}}, {{3.333, 2}, {3.333, 9}}}}.parts());
  const auto contacts = near_contacts(world);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].end, (Point{3.333, 2}));
  EXPECT_EQ(contacts[0].wall, (Segment{{0, 1}, {10, 4}}));
  EXPECT_NEAR(contacts[0].distance, 0.0001 / std::hypot(1, 0.3), 1e-12);
  EXPECT_EQ(text(contacts), "1 end nearly touches another wall, at most 9.58e-05 apart: (3.333, 2) and (0, 1)-(10, 4)");
}

TEST(NearContacts, AreNoneOfWallsThatTouchOrOfAxisParallelOnes) {
  EXPECT_TRUE(near_contacts(t_junction(0)).empty());
  EXPECT_TRUE(near_contacts(t_junction(0.000001)).empty());
  // Overshoots cross: nothing slips through.
  EXPECT_TRUE(near_contacts(World(SmallWorld{.walls = {{{0, 1}, {10, 4}}, {{5, 2.4999}, {5, 9}}}}.parts())).empty());
}

TEST(NearContacts, AreNearerThanATenthOfTheShorterWall) {
  const auto contacts = [](double length) {
    return near_contacts(World(SmallWorld{.walls = {{{0, 1}, {10, 4}}, {{5, 2.501}, {5, 2.501 + length}}}}.parts()));
  };
  EXPECT_EQ(contacts(0.02).size(), 1U);
  EXPECT_EQ(contacts(0.009).size(), 0U);
}

TEST(NearContacts, ListTwoEndsNearToEachOtherOnce) {
  EXPECT_EQ(near_contacts(World(SmallWorld{.walls = {{{0, 1}, {5, 4}}, {{5.001, 4}, {9, 8}}}}.parts())).size(), 1U);
}

TEST(ImpliedBoundary, OfATurnedHallIsItsOuterFace) {
  // Two openings in opposite sides.
  const std::vector<Wall> hall{{{0, 0}, {8, 0}}, {{8, 0}, {8, 2}}, {{8, 3}, {8, 6}}, {{8, 6}, {0, 6}},
                               {{0, 6}, {0, 5}}, {{0, 4}, {0, 0}}, {{4, 0}, {4, 5}}};
  WorldParts parts;
  parts.walls = hall;
  const World flat(parts);
  ASSERT_EQ(flat.boundary(), Boundary::limit);
  for (double degrees = 3; degrees < 360; degrees += 29) {
    const Turn turn(degrees);
    const World world = snapped_world(turn(parts)).world;
    ASSERT_EQ(world.boundary(), Boundary::limit);
    ASSERT_TRUE(world.start() && world.goal().point);
    EXPECT_NEAR(shortest_path(FreeSpace(world), *world.start(), world.goal())->length.value(),
                shortest_path(FreeSpace(flat), *flat.start(), flat.goal())->length.value(), 1e-12);
    // An end in the street opens it, before and after.
    EXPECT_EQ(world.with_ends(turn({9, 7}), std::nullopt).boundary(), Boundary::open);
    EXPECT_EQ(world.with_ends(turn({7, 5}), std::nullopt).boundary(), Boundary::limit);
  }
}

TEST(ImpliedBoundary, OfASlopedHallInWrittenNumbersIsItsOuterFace) {
  WorldParts parts;  // a rectangle of sides 5 and 10, with a door
  parts.walls = {{{0, 0}, {4, 3}}, {{4, 3}, {-2, 11}}, {{-2, 11}, {-6, 8}}, {{-6, 8}, {-3, 4}}, {{-2.4, 3.2}, {0, 0}}};
  const World world(parts);
  EXPECT_EQ(world.boundary(), Boundary::limit);
  EXPECT_EQ(world.openings().size(), 1U);
  EXPECT_EQ(world.areas().front().polygon.outer.size(), 6U);
}

TEST(ImpliedBoundary, OfRoundHallsIsTheirHull) {
  WorldParts parts;
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(Turn(45 * i + 10)({5, 0}));
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) parts.walls.push_back({corners[i], corners[i + 1]});
  EXPECT_EQ(snapped_world(parts).world.boundary(), Boundary::limit);
  parts.walls.pop_back();
  parts.walls.pop_back();
  EXPECT_EQ(snapped_world(parts).world.boundary(), Boundary::open);
}

TEST(ImpliedBoundary, IsOpenAroundWallsThatCloseNothing) {
  WorldParts parts;
  parts.walls = {{{0, 0}, {4, 1}}, {{5, 3}, {1, 6}}};
  EXPECT_EQ(World(parts).boundary(), Boundary::open);
}

}  // namespace
}  // namespace taut
