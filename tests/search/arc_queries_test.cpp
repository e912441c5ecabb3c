#include <taut/search/arc_search.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/roadmaps/all_radii.h>
#include <taut/search/verify_arcs.h>

#include "support/radii_worlds.h"
#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

bool is_one_length(const Interval& a, const Interval& b) {
  return a.lo <= b.hi * (1 + 1e-12) + 1e-12 && b.lo <= a.hi * (1 + 1e-12) + 1e-12;
}

/// The answers for a radius, prepared, not, and without a graph, are those of a graph made for it alone; all verified.
void agrees_at(const AllRadii& all, const Gates& gates, double r, const std::vector<std::array<Point, 2>>& ends) {
  const TangentGraph alone(all.space(), r);
  ArcQueries fresh(all.at_radius(r)), prepared(all.at_radius(r));
  prepared.prepare();
  for (const auto& [s, g] : ends) {
    RC_LOG(fmt::format("s {} g {} r {}\n", test::show(s), test::show(g), r));
    const ArcSearchResult wanted = arc_search(alone, s, g);
    for (const ArcSearchResult& found : {fresh.find(s, g), prepared.find(s, g), arc_search(all, r, s, g)}) {
      RC_ASSERT(found.status == wanted.status);
      RC_ASSERT(found.wall == wanted.wall);
      if (found.status != DiscStatus::found) continue;
      RC_ASSERT(is_one_length(found.path.length, wanted.path.length));
      RC_ASSERT(verify_arcs(found.path, gates, s, g).reason == "");
    }
  }
}

/// TAUT_RADII_HEAVY: 30 radii a world for 2, so that 400 worlds make more than 10^4 pairs.
std::size_t radii_a_world() { return std::getenv("TAUT_RADII_HEAVY") ? 30 : 2; }

void agrees_at_hard_radii(const World& world, const std::vector<std::array<Point, 2>>& ends) {
  const AllRadii all{FreeSpace(world)};
  const Gates gates{FreeSpace(world)};
  const std::vector<double> radii = test::radii_to_ask(all, 20);
  for (std::size_t n = 0; n < radii_a_world(); ++n) {
    double r = radii[static_cast<std::size_t>(test::any(0, int(radii.size()) - 1))];
    // Most events are of discs that get nowhere.
    for (int more = 0; more < 3 && r > 1.2; ++more)
      r = radii[static_cast<std::size_t>(test::any(0, int(radii.size()) - 1))];
    agrees_at(all, gates, r, ends);
  }
}

RC_GTEST_PROP(ArcQueries, AgreeWithASearchOfOneRadiusInMessyWorlds, ()) {
  const test::SmallWorld small =
      test::any_world({.side = 6, .walls = 7, .solids = 2, .straight = test::any(0, 1) == 1});
  const Boundary boundary = std::array{Boundary::walled, Boundary::limit, Boundary::open}[test::any(0, 2)];
  RC_LOG(test::show(small) + fmt::format(" boundary {}\n", int(boundary)));
  std::vector<std::array<Point, 2>> ends;
  for (int n = 0; n < 3; ++n) {
    const Point s = test::any_fine_point(6), g = test::any_fine_point(6);
    ends.push_back({s, g});
  }
  agrees_at_hard_radii(small.bounded(boundary), ends);
}

RC_GTEST_PROP(ArcQueries, AgreeWithASearchOfOneRadiusInMazes, ()) {
  const int width = test::any(2, 6), height = test::any(2, 6), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(width, height, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  RC_LOG(fmt::format("{} x {} seed {}\n", width, height, seed));
  std::vector<std::array<Point, 2>> ends;
  for (int n = 0; n < 3; ++n) {
    const int x = test::any(0, width - 1), y = test::any(0, height - 1), u = test::any(0, width - 1);
    const int v = test::any(0, height - 1);
    ends.push_back({Point{x + 0.5, y + 0.5}, Point{u + 0.5, v + 0.5}});
  }
  agrees_at_hard_radii(world_of(maze), ends);
}

TEST(ArcQueries, PrepareThemselvesAfterAWhile) {
  auto maze = std::make_shared<GridMaze>(generate_backtracker(12, 12, 3));
  open_walls(*maze, 0.3, 3);
  ArcQueries queries(AllRadii(FreeSpace(world_of(maze))).at_radius(0.3));
  const std::size_t before = queries.find({0.5, 0.5}, {11.5, 11.5}).expanded;
  for (int i = 0; i < 40; ++i) queries.find({0.5, 0.5}, {11.5, 11.5});
  EXPECT_LT(queries.find({0.5, 0.5}, {11.5, 11.5}).expanded, before);
}

// Legs lead to the gap on both sides of it; the arc between them is as long as half a circle and meets the other wall.
TEST(ArcQueries, FollowNoArcThroughAGapThatIsTooNarrow) {
  const World world = test::SmallWorld{
      .walls = {{{0, 3}, {5, 3}}, {{5.75, 3}, {10, 3}}, {{1, 2}, {3, 2}}, {{1, 4}, {3, 4}}},
      .solids = {}}.bounded(Boundary::walled);
  const AllRadii all{FreeSpace(world)};
  const Point s{2, 1}, g{2, 5};
  for (const double r : {0.375, 0.38}) {
    ArcQueries fresh(all.at_radius(r)), prepared(all.at_radius(r));
    prepared.prepare();
    for (const ArcSearchResult& found : {fresh.find(s, g), prepared.find(s, g), arc_search(all, r, s, g)})
      EXPECT_EQ(found.status, r == 0.375 ? DiscStatus::found : DiscStatus::none) << r;
  }
}

TEST(ArcQueries, NameTheWallThatAnEndIsTooNearTo) {
  const World world = test::SmallWorld{.walls = {{{3, 3}, {7, 3}}}, .solids = {}}.bounded(Boundary::walled);
  ArcQueries queries(AllRadii(FreeSpace(world)).at_radius(0.6));
  EXPECT_EQ(queries.find({5, 3.5}, {5, 8}).status, DiscStatus::start_blocked);
  EXPECT_EQ(queries.find({5, 8}, {5, 3.5}).status, DiscStatus::goal_blocked);
  EXPECT_EQ(queries.find({5, 8}, {5, 8}).path.value(), 0);
}

}  // namespace
}  // namespace taut
