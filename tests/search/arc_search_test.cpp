#include <taut/search/arc_search.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/search/disc_passage.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify_arcs.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;

ArcSearchResult search(const World& world, Point s, Point g, double r) {
  return arc_search(TangentGraph(FreeSpace(world), r), s, g);
}

/// The regular polygon with `sides` sides around the disc, hardly larger.
Footprint around_disc(double r, int sides) {
  Ring ring;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * M_PI * k / sides, reach = r / std::cos(M_PI / sides) * (1 + 1e-12);
    ring.push_back({reach * std::cos(angle), reach * std::sin(angle)});
  }
  return Footprint::polygon(ring);
}

std::optional<double> polygon_length(const World& world, const Footprint& robot, Point s, Point g) {
  const FreeSpace space(world, robot);
  if (space.locate(s).kind == Location::Kind::outside || space.locate(g).kind == Location::Kind::outside) return {};
  const auto path = shortest_path(space, s, g);
  if (!path) return {};
  return path->length.value();
}

//            g
//   ---------.   around the free end: two equal tangents and the arc between them
//            s
TEST(ArcSearch, BendsAroundTheEndOfAWall) {
  const World world = SmallWorld{.walls = {{{0, 5}, {5, 5}}}, .solids = {}}.bounded(Boundary::walled);
  const auto result = search(world, {2, 2}, {2, 8}, 1);
  ASSERT_EQ(result.status, DiscStatus::found);
  ASSERT_EQ(result.path.bends, (std::vector<ArcBend>{{{5, 5}, 1}}));
  // d = (3, 3): tangents sqrt(18 - 1); the arc is what is left of the turn.
  const double tangent = std::sqrt(17.0), arc = 2 * (M_PI - M_PI / 4 - std::acos(1 / std::sqrt(18.0)));
  EXPECT_NEAR(result.path.value(), 2 * tangent + arc, 1e-14 * 20);
  EXPECT_LE(result.path.length.lo, 2 * tangent + arc + 1e-15);
  EXPECT_GE(result.path.length.hi, 2 * tangent + arc - 1e-15);
  EXPECT_LT(result.path.length.hi - result.path.length.lo, 1e-13);
  EXPECT_EQ(pieces(result.path).size(), 3u);
}

TEST(ArcSearch, HugsBothSidesOfAWallAlongTheWholeHalfCircle) {
  const World world = SmallWorld{.walls = {{{0, 5}, {5, 5}}}, .solids = {}}.bounded(Boundary::walled);
  const auto result = search(world, {2, 4}, {2, 6}, 1);
  ASSERT_EQ(result.status, DiscStatus::found);
  EXPECT_NEAR(result.path.value(), 3 + M_PI + 3, 1e-13);
}

TEST(ArcSearch, PassesADoorThatIsExactlyAsWideAsTheDisc) {
  const World world =
      SmallWorld{.walls = {{{0, 5}, {4, 5}}, {{6, 5}, {10, 5}}}, .solids = {}}.bounded(Boundary::walled);
  const auto result = search(world, {5, 2}, {5, 8}, 1);
  ASSERT_EQ(result.status, DiscStatus::found);
  EXPECT_NEAR(result.path.value(), 6, 1e-14);
  const auto aside = search(world, {2, 3}, {8, 7}, 1);
  ASSERT_EQ(aside.status, DiscStatus::found);
  EXPECT_TRUE(verify_arcs(aside.path, Gates{FreeSpace(world)}, {2, 3}, {8, 7}).valid);
  EXPECT_EQ(search(world, {5, 2}, {5, 8}, std::nextafter(1, 2)).status, DiscStatus::none);
}

TEST(ArcSearch, NamesTheWallThatAnEndIsTooNearTo) {
  const World world = SmallWorld{.walls = {{{3, 3}, {7, 3}}}, .solids = {}}.bounded(Boundary::walled);
  EXPECT_EQ(search(world, {5, 3.5}, {5, 8}, 0.6).status, DiscStatus::start_blocked);
  EXPECT_NE(search(world, {5, 3.5}, {5, 8}, 0.6).wall, kNone);
  EXPECT_EQ(search(world, {5, 8}, {5, 3.5}, 0.6).status, DiscStatus::goal_blocked);
  EXPECT_EQ(search(world, {11, 8}, {5, 3.5}, 0.6).wall, kNone);
  EXPECT_EQ(search(world, {5, 8}, {5, 3.5}, 0.5).status, DiscStatus::found);
}

TEST(ArcSearch, KeepsItsCentreInsideAnOpening) {
  const SmallWorld small{.walls = {{{0, 0}, {10, 0}}, {{0, 10}, {10, 10}}, {{0, 0}, {0, 10}}, {{0, 5}, {9, 5}}},
                         .solids = {}};
  const World world = small.bounded(Boundary::limit);
  const auto result = search(world, {10, 2}, {10, 8}, 1);
  ASSERT_EQ(result.status, DiscStatus::found);
  EXPECT_NEAR(result.path.value(), 6, 1e-14);
  EXPECT_EQ(search(world, {10, 2}, {10, 8}, 1.01).status, DiscStatus::none);
}

TEST(ArcSearch, IsBoundedByPolygonsOfMoreAndMoreSides) {
  const World world =
      SmallWorld{.walls = {{{0, 3}, {6, 3}}, {{4, 6}, {10, 6.5}}}, .solids = {}}.bounded(Boundary::walled);
  const auto result = search(world, {2, 1.5}, {8, 8.5}, 1);
  ASSERT_EQ(result.status, DiscStatus::found);
  double last = HUGE_VAL;
  for (const int sides : {8, 16, 32, 64, 128}) {
    const auto length = polygon_length(world, around_disc(1, sides), {2, 1.5}, {8, 8.5});
    ASSERT_TRUE(length);
    EXPECT_GE(*length, result.path.length.lo);
    EXPECT_LE(*length, last + 1e-9);
    last = *length;
  }
  EXPECT_NEAR(last, result.path.value(), 2e-3);
}

TEST(VerifyArcs, RefusesWhatCutsACorner) {
  const World world = SmallWorld{.walls = {{{0, 5}, {5, 5}}}, .solids = {}}.bounded(Boundary::walled);
  const Gates gates{FreeSpace(world)};
  ArcPath path = search(world, {2, 2}, {2, 8}, 1).path;
  EXPECT_TRUE(verify_arcs(path, gates, {2, 2}, {2, 8}).valid);
  ArcPath wrong = path;
  wrong.bends[0].turn = -1;
  EXPECT_FALSE(verify_arcs(wrong, gates, {2, 2}, {2, 8}).valid);
  wrong = path;
  wrong.bends.clear();
  EXPECT_FALSE(verify_arcs(wrong, gates, {2, 2}, {2, 8}).valid);
  wrong = path;
  wrong.bends[0].corner.x = std::nextafter(5, 0);
  EXPECT_FALSE(verify_arcs(wrong, gates, {2, 2}, {2, 8}).valid);
  wrong = path;
  wrong.length = {1, 2};
  EXPECT_FALSE(verify_arcs(wrong, gates, {2, 2}, {2, 8}).valid);
}

// Below the wall's end to the left of the disc's middle, and on to where only a turn to the right leads.
TEST(VerifyArcs, RefusesAnArcThatTurnsAgainstItsDirection) {
  const World world = SmallWorld{.walls = {{{5, 5}, {5, 9}}}, .solids = {}}.bounded(Boundary::walled);
  const Gates gates{FreeSpace(world)};
  ArcPath path{.radius = 1, .start = {1, 4}, .goal = {9, 3.5}, .bends = {{{5, 5}, 1}}, .length = {}};
  path.length = length_of(pieces(path));
  EXPECT_EQ(verify_arcs(path, gates, path.start, path.goal).reason, "arc 0 does not turn as it says");
  path.goal = {9, 4.5};
  path.length = length_of(pieces(path));
  const ArcVerdict verdict = verify_arcs(path, gates, path.start, path.goal);
  EXPECT_TRUE(verdict.valid) << verdict.reason;
}

/// The answer is that of disc_passage, it verifies, and it is no longer than the polygon's.
void is_right(const World& world, Point s, Point g, double r) {
  const Gates gates{FreeSpace(world)};
  const auto result = search(world, s, g, r);
  const DiscStatus expected = disc_passage(gates, s, g, r).status;
  RC_ASSERT((result.status == DiscStatus::found) == (expected == DiscStatus::found));
  RC_ASSERT((result.status == DiscStatus::start_blocked) == (expected == DiscStatus::start_blocked));
  RC_ASSERT((result.status == DiscStatus::goal_blocked) == (expected == DiscStatus::goal_blocked));
  if (result.status != DiscStatus::found) return;
  const ArcVerdict verdict = verify_arcs(result.path, gates, s, g);
  RC_LOG(verdict.reason + "\n");
  RC_ASSERT(verdict.valid);
  const auto point = polygon_length(world, Footprint::point(), s, g);
  RC_ASSERT(point && *point <= result.path.length.hi);
  const auto back = search(world, g, s, r);
  RC_ASSERT(back.status == DiscStatus::found && std::abs(back.path.value() - result.path.value()) < 1e-11);
  if (const auto polygon = polygon_length(world, Footprint::disc(r), s, g))
    RC_ASSERT(result.path.length.lo <= *polygon + 1e-12);
  // A slightly smaller disc's polygon lies within the disc: its path is no longer.
  const auto inner = polygon_length(world, Footprint::disc(r / (1 + 1.001 * Footprint::kDiscExcess)), s, g);
  RC_ASSERT(inner && *inner <= result.path.length.hi + 1e-9);
}

RC_GTEST_PROP(ArcSearch, AgreesWithGatesAndPolygonsInMessyWorlds, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 7, .solids = 2, .straight = test::any(0, 1) == 1});
  const World world = small.bounded(std::array{Boundary::walled, Boundary::limit, Boundary::open}[test::any(0, 2)]);
  for (int n = 0; n < 3; ++n) {
    const Point s = test::any_fine_point(6), g = test::any_fine_point(6);
    const double r = test::any(0, 1) ? test::any(1, 8) / 8.0 : test::any(1, 70) / 100.0 + 0.0013;
    RC_LOG(test::show(small) +
           fmt::format(" boundary {} s {} g {} r {}\n", int(world.boundary()), test::show(s), test::show(g), r));
    is_right(world, s, g, r);
  }
}

RC_GTEST_PROP(ArcSearch, AgreesWithGatesAndPolygonsInMazes, ()) {
  const int width = test::any(2, 6), height = test::any(2, 6), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(width, height, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  const World world = world_of(maze);
  const Point s{test::any(0, width - 1) + 0.5, test::any(0, height - 1) + 0.5};
  const Point g{test::any(0, width - 1) + 0.5, test::any(0, height - 1) + 0.5};
  for (const double r : {0.25, 0.31, 0.5}) {
    RC_LOG(fmt::format("{} x {} seed {} s {} g {} r {}\n", width, height, seed, test::show(s), test::show(g), r));
    is_right(world, s, g, r);
  }
}

}  // namespace
}  // namespace taut
