#include <taut/search/funnel.h>

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <taut/geometry/maze_generator.h>
#include <taut/search/prm_planner.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using test::any_world;
using test::SmallWorld;

Path path_through(std::vector<Point> points) {
  Length length(points);
  return {std::move(points), std::move(length)};
}

std::vector<Point> pulled(const FreeSpace& space, std::vector<Point> points) {
  const auto result = shortened(space, path_through(std::move(points)));
  return result ? result->points : std::vector<Point>{};
}

using Points = std::vector<Point>;

// A wall from the floor up to (5, 6):
//
//        |
//   a    |    b
const SmallWorld kScreen{.walls = {{{5, 0}, {5, 6}}}, .solids = {}};

TEST(Funnel, PullsADetourOverTheEndOfAWall) {
  const FreeSpace space = kScreen.space();
  EXPECT_EQ(pulled(space, {{2, 2}, {3, 9}, {8, 9}, {8, 2}}), (Points{{2, 2}, {5, 6}, {8, 2}}));
  EXPECT_EQ(pulled(space, {{2, 2}, {3, 9}, {8, 9}, {8, 9.5}}), (Points{{2, 2}, {5, 6}, {8, 9.5}}));
  EXPECT_EQ(pulled(space, {{2, 4}, {3, 9}, {8, 9}, {8, 9.5}}), (Points{{2, 4}, {8, 9.5}}));
}

TEST(Funnel, TurnsBackAlongTheOtherSideOfAWall) {
  const FreeSpace space = kScreen.space();
  EXPECT_EQ(pulled(space, {{5, 2}, {4, 2}, {4, 9}, {6, 9}, {6, 2}, {5, 2}}), (Points{{5, 2}, {5, 6}, {5, 2}}));
  EXPECT_EQ(pulled(space, {{5, 2}, {5, 6}, {5, 2}}), (Points{{5, 2}, {5, 6}, {5, 2}})) << "it can be taut, so it is";
  EXPECT_EQ(pulled(space, {{5, 2}, {4, 2}, {4, 9}, {4, 2}, {5, 2}}), (Points{{5, 2}}))
      << "it was never on the other side";
}

TEST(Funnel, LeavesOutSpursAndRepeatedPoints) {
  const FreeSpace space = kScreen.space();
  EXPECT_EQ(pulled(space, {{2, 2}, {2, 2}, {4, 9}, {9, 9}, {4, 9}, {3, 3}, {3, 3}}), (Points{{2, 2}, {3, 3}}));
  EXPECT_EQ(pulled(space, {{2, 2}, {5, 6}, {8, 9}, {5, 6}, {2, 2}}), (Points{{2, 2}}));
  EXPECT_EQ(pulled(space, {{2, 2}}), (Points{{2, 2}}));
}

TEST(Funnel, KeepsTheWayAroundAnObstacle) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {test::box_ring(4, 4, 6, 6)}}.space();
  EXPECT_EQ(pulled(space, {{5, 2}, {2, 3}, {2, 8}, {5, 8}}), (Points{{5, 2}, {4, 4}, {4, 6}, {5, 8}}));
  EXPECT_EQ(pulled(space, {{5, 2}, {8, 3}, {8, 8}, {5, 8}}), (Points{{5, 2}, {6, 4}, {6, 6}, {5, 8}}));
}

TEST(Funnel, WindsAroundAnObstacleAsOftenAsThePathDoes) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {test::box_ring(4, 4, 6, 6)}}.space();
  const Points turn{{3, 3}, {7, 3}, {7, 7}, {3, 7}};
  Points twice;
  for (int i = 0; i < 2; ++i) twice.insert(twice.end(), turn.begin(), turn.end());
  twice.push_back({3, 3});
  EXPECT_EQ(pulled(space, twice), (Points{{3, 3}, {6, 4}, {6, 6}, {4, 6}, {4, 4}, {6, 4}, {6, 6}, {4, 6}, {3, 3}}));
}

TEST(Funnel, RefusesWhatIsNoPath) {
  const FreeSpace space = kScreen.space();
  EXPECT_FALSE(shortened(space, path_through({{2, 2}, {8, 2}}))) << "through a wall";
  EXPECT_FALSE(shortened(space, path_through({{2, 2}, {12, 2}}))) << "out of the world";
  EXPECT_FALSE(shortened(space, path_through({}))) << "no points";
  const FreeSpace joint = SmallWorld{.walls = {{{5, 0}, {5, 6}}, {{5, 6}, {7, 10}}}, .solids = {}}.space();
  EXPECT_FALSE(shortened(joint, path_through({{2, 6}, {5, 6}, {8, 6}}))) << "through a joint";
}

TEST(Funnel, TakesTheSideOfAWallOnWhichThePathIsTaut) {
  const FreeSpace space = SmallWorld{.walls = {{{2, 5}, {8, 5}}}, .solids = {}}.space();
  EXPECT_EQ(pulled(space, {{1, 1}, {2, 5}, {8, 5}, {9, 1}}).size(), 4u) << "above the wall";
  EXPECT_EQ(pulled(space, {{1, 9}, {2, 5}, {8, 5}, {9, 9}}).size(), 4u) << "below it";
  EXPECT_EQ(pulled(space, {{1, 1}, {2, 4}, {8, 4}, {9, 1}}), (Points{{1, 1}, {9, 1}}));
  EXPECT_EQ(pulled(space, {{0, 5}, {10, 5}}), (Points{{0, 5}, {10, 5}}));
}

TEST(Funnel, IsTheShortestPathOfAPerfectMaze) {
  for (const int side : {3, 9, 25})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const World world = world_of(std::make_shared<GridMaze>(generate_biased_maze(side, side, seed)));
      const FreeSpace space(world);
      PrmPlan plan;
      plan.roadmap.seed = seed;
      const PrmResult prm = prm_path(space, *world.start(), world.goal(), plan);
      ASSERT_EQ(prm.search.status, SearchStatus::found);
      const auto path = shortened(space, prm.search.path);
      ASSERT_TRUE(path);
      EXPECT_EQ(path->length, shortest_path(space, *world.start(), world.goal())->length);
      EXPECT_EQ(verify(*path, space, *world.start(), world.goal()).reason, "");
    }
}

/// A path that wanders over the world by legs that are free: of `steps` draws those that can be seen.
Points any_walk(const FreeSpace& space, int steps, int side) {
  Points points;
  while (steps-- > 0) {
    const int x = any(0, 4 * side), y = any(0, 4 * side), coarse = any(0, 1);
    const Point p = coarse ? Point{double(x / 4), double(y / 4)} : Point{x / 4.0, y / 4.0};
    if (space.locate(p).kind == Location::Kind::outside) continue;
    Points longer = points;
    longer.push_back(p);
    if (points.empty() || verify(path_through(longer), space, longer.front(), Goal{p, {}}).valid) points = longer;
  }
  return points;
}

RC_GTEST_PROP(Funnel, IsAPathNoLongerThanTheOneItCameFromAndCannotBePulledTwice, ()) {
  const SmallWorld world = any_world({.walls = 12});
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const Points walk = any_walk(space, 30, 6);
  RC_PRE(!walk.empty());
  for (const Point p : walk) RC_LOG() << test::show(p) << ", ";
  const Path path = path_through(walk);
  const auto taut = shortened(space, path);
  RC_ASSERT(taut.has_value());
  RC_ASSERT(verify(*taut, space, walk.front(), Goal{walk.back(), {}}).reason == "");
  RC_ASSERT(taut->length <= path.length);
  RC_ASSERT(taut->length == Length(taut->points));
  RC_ASSERT(shortened(space, *taut)->points == taut->points);
  const auto shortest = shortest_path(space, walk.front(), walk.back());
  RC_ASSERT(shortest.has_value());
  RC_ASSERT(taut->length >= shortest->length);
}

RC_GTEST_PROP(Funnel, RefusesExactlyWhatTheCheckRefuses, ()) {
  const SmallWorld world = any_world({.walls = 6});
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  Points points;
  for (int n = any(1, 5); n > 0; --n) points.push_back(test::any_lattice_point(6));
  for (const Point p : points) RC_LOG() << test::show(p) << ", ";
  const bool valid = verify(path_through(points), space, points.front(), Goal{points.back(), {}}).valid;
  RC_CLASSIFY(valid, "paths");
  RC_ASSERT(shortened(space, path_through(points)).has_value() == valid);
}

/// Is there no shortcut at any bend, however small?
bool is_taut(const FreeSpace& space, const Points& points) {
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    for (double t = 0.5; t > 1e-4; t /= 2) {
      const auto towards = [&](Point p) -> Point {
        return {points[i].x + t * (p.x - points[i].x), points[i].y + t * (p.y - points[i].y)};
      };
      const Point a = towards(points[i - 1]), b = towards(points[i + 1]);
      if (verify(path_through({a, b}), space, a, Goal{b, {}}).valid) return false;
    }
  return true;
}

SmallWorld any_blocks() { return any_world({.walls = 0, .solids = 6}); }

RC_GTEST_PROP(Funnel, LeavesNoShortcutAtAnyBend, ()) {
  const SmallWorld world = any_blocks();
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const Points walk = any_walk(space, 12, 6);
  RC_PRE(!walk.empty());
  const Points taut = pulled(space, walk);
  RC_CLASSIFY(taut.size() > 2, "bends");
  RC_ASSERT(is_taut(space, taut));
}

RC_GTEST_PROP(Funnel, PullsAWholeAsItPullsItsParts, ()) {
  const SmallWorld world = any_blocks();
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const Points walk = any_walk(space, 20, 6);
  RC_PRE(walk.size() > 2);
  for (const Point p : walk)  // not where two blocks touch: a point there is in two places
    if (const Location at = space.locate(p); at.kind == Location::Kind::vertex)
      RC_PRE(space.triangulation().sectors_at(space.triangulation().triangles[at.triangle][at.index]).size() == 1);
  const auto middle = walk.begin() + any(1, static_cast<int>(walk.size()) - 2);
  Points parts = pulled(space, Points(walk.begin(), middle + 1));
  const Points rest = pulled(space, Points(middle, walk.end()));
  parts.insert(parts.end(), rest.begin(), rest.end());
  RC_ASSERT(pulled(space, parts) == pulled(space, walk));
  Points backwards = pulled(space, Points(walk.rbegin(), walk.rend()));
  std::reverse(backwards.begin(), backwards.end());
  RC_ASSERT(backwards == pulled(space, walk));
}

RC_GTEST_PROP(Funnel, FindsTheShortestPathAgainFromAnyPerturbationOfIt, ()) {
  const SmallWorld world = any_blocks();
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const auto place = [] {
    const int x = any(0, 24), y = any(0, 24);
    return Point{x / 4.0, y / 4.0};
  };
  const Point from = place(), to = place();
  RC_PRE(space.locate(from).kind != Location::Kind::outside && space.locate(to).kind != Location::Kind::outside);
  const auto shortest = shortest_path(space, from, to);
  RC_PRE(shortest.has_value());
  Points points;  // between its points it goes to places that it sees, and back
  for (const Point p : shortest->points) {
    points.push_back(p);
    const Point aside = place();
    if (verify(path_through({p, aside}), space, p, Goal{aside, {}}).valid) points.insert(points.end(), {aside, p});
  }
  const auto taut = shortened(space, path_through(points));
  RC_PRE(taut.has_value());  // it may go off to the wrong side of a joint
  RC_CLASSIFY(points.size() > shortest->points.size() && shortest->points.size() > 2, "perturbed, with bends");
  RC_ASSERT(taut->length == shortest->length);
}

}  // namespace
}  // namespace taut
