#include <taut/search/disc_passage.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <taut/geometry/detail/segment_distance.h>
#include <taut/geometry/maze_generator.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;

World walled(const SmallWorld& world) {
  auto parts = world.parts();
  parts.boundary = Boundary::walled;
  return World(parts);
}

World room(const std::vector<Segment>& walls) { return walled({.walls = walls, .solids = {}}); }

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

PassageStatus status(const World& world, Point s, Point g, double r) {
  return disc_passage(FreeSpace(world), s, g, r).status;
}

/// What the inflated polygon says: true when connected; nothing when an end is no place for it.
std::optional<bool> inflated(const World& world, Point s, Point g, double r) {
  const FreeSpace space(world, Footprint::disc(r));
  const Location from = space.locate(s), to = space.locate(g);
  if (from.kind == Location::Kind::outside || to.kind == Location::Kind::outside) return std::nullopt;
  return space.component(from.triangle) == space.component(to.triangle);
}

/// Flood of a grid of points whose distance to all walls is at least r.
bool flooded(const Gates& gates, Point s, Point g, double r, double side, int steps) {
  const auto& all = gates.space().constraints();
  const double step = side / steps;
  const auto is_place = [&](Point p) {
    if (gates.space().locate(p).kind == Location::Kind::outside) return false;
    for (std::uint32_t c = 0; c < all.size(); ++c)
      if (!gates.is_opening(c) && detail::segment_distance_interval({p, p}, {all[c].a, all[c].b}).hi < r) return false;
    return true;
  };
  const auto node = [&](Point p) { return std::lround(p.y / step) * (steps + 1) + std::lround(p.x / step); };
  std::vector<char> place;
  for (int y = 0; y <= steps; ++y)
    for (int x = 0; x <= steps; ++x) place.push_back(is_place({x * step, y * step}));
  if (!place[node(s)] || !place[node(g)]) return false;
  std::vector<long> open{node(s)};
  place[open[0]] = 0;
  while (!open.empty()) {
    const long at = open.back();
    open.pop_back();
    if (at == node(g)) return true;
    const long x = at % (steps + 1), y = at / (steps + 1);
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      if (x + dx < 0 || x + dx > steps || y + dy < 0 || y + dy > steps) continue;
      const long next = at + dy * (steps + 1) + dx;
      if (place[next]) place[next] = 0, open.push_back(next);
    }
  }
  return false;
}

/// The chain of pieces closes, and does so around exactly one of s and g (winding by angles).
bool separates(const Gates& gates, const std::vector<BarrierPiece>& barrier, Point s, Point g) {
  const auto ends = [&](const BarrierPiece& piece) {
    if (piece.gate != kNone) return Segment{gates.gates()[piece.gate].end, gates.gates()[piece.gate].foot};
    const Constraint& c = gates.space().constraints()[piece.constraint];
    return Segment{c.a, c.b};
  };
  // Pieces of one chain touch; where exactly is the point of the next nearest to this.
  std::vector<Point> chain;
  for (std::size_t i = 0; i < barrier.size(); ++i) {
    const Segment here = ends(barrier[i]), next = ends(barrier[(i + 1) % barrier.size()]);
    Point joint = here.a;
    double least = HUGE_VAL;
    for (const Point p : {here.a, here.b, next.a, next.b}) {
      const double apart = detail::segment_distance({p, p}, here) + detail::segment_distance({p, p}, next);
      if (apart < least) least = apart, joint = p;
    }
    if (least > 1e-9) return false;
    chain.push_back(joint);
  }
  const auto winding = [&](Point p) {
    double turn = 0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Point a = chain[i], b = chain[(i + 1) % chain.size()];
      turn += std::atan2((a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x),
                         (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y));
    }
    return std::lround(turn / (2 * M_PI));
  };
  return winding(s) != winding(g);
}

TEST(DiscPassage, ADoorLetsThroughWhatIsNoWiderThanIt) {
  const World world = rooms_with_doors({{4, 2}});
  EXPECT_EQ(status(world, {5, 2}, {5, 8}, 1), PassageStatus::reachable);
  EXPECT_EQ(status(world, {5, 2}, {5, 8}, std::nextafter(1, 2)), PassageStatus::separated);
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
  ASSERT_EQ(blocked.status, PassageStatus::separated);
  EXPECT_EQ(
      std::count_if(blocked.barrier.begin(), blocked.barrier.end(), [](const auto& p) { return p.gate != kNone; }), 2);
  EXPECT_TRUE(separates(gates, blocked.barrier, {5, 2}, {5, 8}));
}

TEST(DiscPassage, AnEndNearAWallIsNoPlace) {
  const Gates gates{FreeSpace(room({{{3, 3}, {7, 3}}}))};
  EXPECT_EQ(disc_passage(gates, {5, 3.5}, {5, 8}, 0.6).status, PassageStatus::start_blocked);
  EXPECT_EQ(disc_passage(gates, {5, 8}, {5, 3.5}, 0.6).status, PassageStatus::goal_blocked);
  EXPECT_EQ(disc_passage(gates, {5, 8}, {5, 3.5}, 0.5).status, PassageStatus::reachable);
  EXPECT_EQ(disc_passage(gates, {11, 8}, {5, 3.5}, 0.5).status, PassageStatus::start_blocked);
  const auto widest = widest_passage(gates, {5, 8}, {5, 3.5});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->limit, WidestPassage::Limit::goal);
  EXPECT_EQ(widest->radius, 0.5);
}

TEST(DiscPassage, ClosedRoomsAreSeparatedForAnyRadius) {
  const Gates gates{FreeSpace(room({{{0, 5}, {10, 5}}}))};
  EXPECT_FALSE(widest_passage(gates, {5, 2}, {5, 8}));
  const DiscPassage blocked = disc_passage(gates, {5, 2}, {5, 8}, 1e-6);
  EXPECT_EQ(blocked.status, PassageStatus::separated);
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
  EXPECT_EQ(disc_passage(gates, {5, 2}, {5, 8}, 1).status, PassageStatus::reachable);
  EXPECT_EQ(disc_passage(gates, {10, 2}, {10, 8}, 1).status, PassageStatus::reachable);
  EXPECT_EQ(disc_passage(gates, {10, 2}, {10, 8}, 1.01).status, PassageStatus::separated);
  EXPECT_EQ(disc_passage(gates, {10, 5}, {10, 8}, 1).status, PassageStatus::reachable);
}

TEST(DiscPassage, AWallOnTheOutlineOfAnOpenWorldIsAWall) {
  auto parts = SmallWorld{.walls = {{{0, 0}, {0, 1}}}, .solids = {}}.parts();
  parts.boundary = Boundary::open;
  const FreeSpace space{World(parts)};
  EXPECT_EQ(disc_passage(space, {0.25, 0.5}, {5, 5}, 0.5).status, PassageStatus::start_blocked);
  EXPECT_EQ(disc_passage(space, {0.25, 2}, {5, 5}, 0.5).status, PassageStatus::reachable);
}

TEST(DiscPassage, AWallReachesOutThroughAnOpening) {
  // A slot that is not part of the world, between a wall and a door's other post: the centre cannot be there, but the disc can.
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
    EXPECT_EQ(disc_passage(gates, *world.start(), *world.goal().point, 0.5).status, PassageStatus::reachable);
  }
}

/// Both ways to one answer, for one radius that is not within the polygon's excess of a critical one.
void agrees_with_inflation(const World& world, const Gates& gates, Point s, Point g, double r) {
  const DiscPassage passage = disc_passage(gates, s, g, r);
  if (inflated(world, s, g, r) == true) RC_ASSERT(passage.status == PassageStatus::reachable);
  if (inflated(world, s, g, r / (1 + 1.001 * Footprint::kDiscExcess)) != true)
    RC_ASSERT(passage.status != PassageStatus::reachable);
  if (passage.status == PassageStatus::separated) RC_ASSERT(separates(gates, passage.barrier, s, g));
}

Point any_point(int side) {
  const int x = test::any(1, 64 * side - 1), y = test::any(1, 64 * side - 1);
  return {x / 64.0, y / 64.0};
}

RC_GTEST_PROP(DiscPassage, AgreesWithTheInflatedPolygonInMessyWorlds, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 7, .solids = 2, .straight = test::any(0, 1) == 1});
  auto parts = small.parts();
  parts.boundary = std::array{Boundary::walled, Boundary::limit, Boundary::open}[test::any(0, 2)];
  const World world(parts);
  const Gates gates{FreeSpace(world)};
  for (int n = 0; n < 6; ++n) {
    const Point s = any_point(6), g = any_point(6);
    const double r = test::any(1, 70) / 100.0 + 0.0013;
    RC_LOG(test::show(small) + fmt::format(" s {} g {} r {}\n", test::show(s), test::show(g), r));
    agrees_with_inflation(world, gates, s, g, r);
  }
}

RC_GTEST_PROP(DiscPassage, IsBoundedByTheWidest, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 7, .solids = 2});
  RC_LOG(test::show(small));
  const World world = walled(small);
  const Gates gates{FreeSpace(world)};
  for (int n = 0; n < 6; ++n) {
    const Point s = any_point(6), g = any_point(6);
    const auto widest = widest_passage(gates, s, g);
    if (!widest) {
      RC_ASSERT(disc_passage(gates, s, g, 1e-9).status != PassageStatus::reachable);
      continue;
    }
    if (widest->radius == 0) continue;
    RC_LOG(fmt::format(" s {} g {} radius {}\n", test::show(s), test::show(g), widest->radius));
    RC_ASSERT(disc_passage(gates, s, g, widest->radius).status == PassageStatus::reachable);
    RC_ASSERT(disc_passage(gates, s, g, std::nextafter(widest->radius, 9)).status != PassageStatus::reachable);
    if (widest->radius < 1e-9) continue;  // the inflated world cannot be rounded that finely
    RC_ASSERT(inflated(world, s, g, widest->radius * 0.998) == true);
    RC_ASSERT(inflated(world, s, g, widest->radius * 1.0001) != true);
    const auto back = widest_passage(gates, g, s);
    RC_ASSERT(back && back->radius == widest->radius);
  }
}

RC_GTEST_PROP(DiscPassage, AgreesWithAFineGrid, ()) {
  const SmallWorld small = test::any_world({.side = 4, .walls = 5, .solids = 1});
  RC_LOG(test::show(small));
  const Gates gates{FreeSpace(walled(small))};
  const int steps = 96;
  const double step = 4.0 / steps;
  const auto node = [&] { return Point{test::any(1, steps - 1) * step, test::any(1, steps - 1) * step}; };
  const Point s = node(), g = node();
  const double r = test::any(10, 60) / 100.0 + 0.0013;
  // A step keeps within 1/2 of a node; a free path stays within 0.71 steps of nodes.
  if (flooded(gates, s, g, r + 0.51 * step, 4, steps))
    RC_ASSERT(disc_passage(gates, s, g, r).status == PassageStatus::reachable);
  if (!flooded(gates, s, g, r - 0.72 * step, 4, steps))
    RC_ASSERT(disc_passage(gates, s, g, r).status != PassageStatus::reachable);
}

RC_GTEST_PROP(DiscPassage, AgreesWithTheInflatedPolygonInOpenedMazes, ()) {
  const int width = test::any(2, 6), height = test::any(2, 6), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(width, height, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  const World world = world_of(maze);
  const Gates gates{FreeSpace(world)};
  const Point s{test::any(0, width - 1) + 0.5, test::any(0, height - 1) + 0.5};
  const Point g{test::any(0, width - 1) + 0.5, test::any(0, height - 1) + 0.5};
  for (const double r : {0.1, 0.31, 0.498, 0.4993}) agrees_with_inflation(world, gates, s, g, r);
  const auto widest = widest_passage(gates, s, g);
  RC_ASSERT(widest && widest->radius >= 0.5);
}

}  // namespace
}  // namespace taut
