#include <taut/search/shortest_path.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/verify.h>

#include "support/messy_world.h"
#include "support/paths.h"
#include "support/random_world.h"
#include "support/refusal.h"

namespace taut {
namespace {

using test::any;
using test::any_world;
using test::box_ring;
using test::SmallWorld;

std::string length_of(const SmallWorld& world, Point from, Point to) {
  const auto path = shortest_path(world.space(), from, to);
  return path ? path->length.decimals(6) : "none";
}

std::string solved(const std::string& drawing) {
  const World world = read_world(drawing);
  const auto path = shortest_path(FreeSpace(world), *world.start(), world.goal());
  return path ? path->length.decimals(6) : "none";
}

TEST(ShortestPath, GoesAroundTheFreeEndOfAWall) {
  EXPECT_EQ(length_of({.walls = {{{5, 0}, {5, 6}}}, .solids = {}}, {2, 2}, {8, 2}), "10.000000");
}

TEST(ShortestPath, IsAbsentWhenAWallSeparatesTheEnds) {
  EXPECT_EQ(length_of({.walls = {{{5, 0}, {5, 10}}}, .solids = {}}, {2, 2}, {8, 2}), "none");
}

TEST(ShortestPath, DoesNotSlipThroughAJointOfTwoWalls) {
  const SmallWorld joined{.walls = {{{0, 5}, {5, 5}}, {{5, 5}, {10, 5}}}, .solids = {}};
  EXPECT_EQ(length_of(joined, {5, 2}, {5, 8}), "none");
  const SmallWorld crooked{.walls = {{{0, 3}, {5, 5}}, {{5, 5}, {10, 3}}}, .solids = {}};
  EXPECT_EQ(length_of(crooked, {5, 2}, {5, 8}), "none");
}

TEST(ShortestPath, DoesNotSlipBetweenBlocksThatTouchInAPoint) {
  const SmallWorld world{.walls = {}, .solids = {box_ring(0, 0, 5, 5), box_ring(5, 5, 10, 10)}};
  EXPECT_EQ(length_of(world, {8, 2}, {2, 8}), "none");
}

TEST(ShortestPath, DoesNotRunAlongTheSeamOfAdjacentBlocks) {
  const SmallWorld world{.walls = {}, .solids = {box_ring(2, 2, 5, 8), box_ring(5, 2, 8, 8)}};
  EXPECT_EQ(length_of(world, {5, 2}, {5, 8}), "12.000000");
}

TEST(ShortestPath, RunsAlongAWallOnBothSidesOfAStub) {
  // Past the stub's foot the way along the wall is free on the other side only.
  const SmallWorld world{.walls = {{{1, 5}, {9, 5}}, {{5, 5}, {5, 8}}}, .solids = {}};
  EXPECT_EQ(length_of(world, {1, 5}, {9, 5}), "8.000000");
  EXPECT_EQ(length_of(world, {4, 6}, {6, 6}), "4.472136") << "over the stub's free end, not under its foot";
}

TEST(ShortestPath, StartsOnAWallOnWhicheverSideIsNearer) {
  const SmallWorld world{.walls = {{{2, 5}, {8, 5}}}, .solids = {}};
  EXPECT_EQ(length_of(world, {5, 5}, {5, 7}), "2.000000");
  EXPECT_EQ(length_of(world, {5, 5}, {5, 3}), "2.000000");
}

TEST(ShortestPath, IsAPointWhenStartIsGoal) {
  const auto path = shortest_path(SmallWorld{}.space(), {1, 1}, {1, 1});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points, std::vector<Point>{(Point{1, 1})});
  EXPECT_EQ(path->length, Length());
}

TEST(ShortestPath, EndsWhereItEntersTheRoom) {
  EXPECT_EQ(solved("o---o---o---o\n"
                   "| S       G |\n"
                   "o---o---o---o\n"),
            "1.500000");
  EXPECT_EQ(solved("o---o---o---o\n"
                   "| S |     G |\n"
                   "o   o   o   o\n"
                   "|           |\n"
                   "o---o---o---o\n"),
            "1.707107")
      << "around the wall's end, then straight to the room's nearest point";
}

TEST(ShortestPath, DoesNotEnterARoomThroughItsWall) {
  EXPECT_EQ(solved("o---o---o\n"
                   "| S | G |\n"
                   "o   o   o\n"
                   "|       |\n"
                   "o---o---o\n"),
            "0.707107")
      << "to the wall's end, where the room's open side begins";
  EXPECT_EQ(solved("o---o---o\n"
                   "| S | G |\n"
                   "o   o---o\n"
                   "|       |\n"
                   "o---o---o\n"),
            "none");
}

TEST(ShortestPath, ThrowsWhenAnEndIsNoPlaceToBe) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {box_ring(2, 2, 5, 8)}}.space();
  const auto message = [&](Point from, Point to) -> std::string {
    return test::refusal_of([&] { shortest_path(space, from, to); });
  };
  EXPECT_EQ(message({3, 3}, {8, 8}),
            "start (3, 3) lies 1 inside the obstacle with the side from (2, 2) to (5, 2); nearest free point (2, 3)");
  EXPECT_EQ(message({1, 1}, {11, 8}), "goal (11, 8) lies 1 outside the world; nearest free point (10, 8)");
}

TEST(ShortestPath, HasThePublishedLengthsInMazesOpenAtTwoCorners) {
  std::vector<std::pair<std::filesystem::path, const char*>> published{
      {test::data_dir() / "maze_5x7.txt", "9.321693"}, {test::data_dir() / "maze_45x45.txt", "97.622073"}};
  if (const auto shared = test::shared_data_dir())
    for (const auto& [file, length] : {std::pair{"maze_5x7_s1.txt", "8.662332"},
                                       {"maze_5x7_s2.txt", "9.072510"},
                                       {"maze_41x41_s1.txt", "77.262691"},
                                       {"maze_45x45_s1.txt", "97.581050"}})
      published.emplace_back(*shared / "prm" / file, length);
  for (const auto& [file, length] : published) {
    const World world = read_world_file(file.string());
    const auto path = shortest_path(FreeSpace(world), *world.start(), world.goal());
    ASSERT_TRUE(path) << file;
    EXPECT_EQ(path->length.decimals(6), length) << file;
  }
}

/// Whether there is a path; it is a valid one then.
bool finds_a_valid_path(const World& world, const std::string& name) {
  const FreeSpace space(world);
  const auto path = shortest_path(space, *world.start(), world.goal());
  if (!path) return false;
  const Verdict verdict = verify(*path, space, *world.start(), world.goal());
  EXPECT_TRUE(verdict.valid) << name << ": " << verdict.reason;
  return true;
}

TEST(ShortestPath, IsFoundAndValidInEveryMouseMazeThatConnectsStartAndGoal) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    auto maze = std::make_shared<GridMaze>(generate_backtracker(8 + 2 * static_cast<int>(seed % 5), 16, seed));
    open_walls(*maze, 0.01 * static_cast<double>(seed % 30), seed);
    EXPECT_TRUE(finds_a_valid_path(world_of(std::move(maze)), "seed " + std::to_string(seed)));
  }
  for (const auto& file : test::own_mazes())
    EXPECT_TRUE(finds_a_valid_path(read_world_file(file.string()), file.string()));
  const auto shared = test::shared_files("micromouse");
  EXPECT_GE(
      std::ranges::count_if(
          shared, [](const auto& file) { return finds_a_valid_path(read_world_file(file.string()), file.string()); }),
      shared.empty() ? 0 : 66);
}

TEST(ShortestPathTree, GivesThePathsOfSingleQueries) {
  const SmallWorld world{.walls = {{{5, 0}, {5, 6}}, {{2, 6}, {5, 6}}, {{7, 3}, {7, 10}}},
                         .solids = {box_ring(1, 1, 3, 3)}};
  const auto graph = std::make_shared<VisibilityGraph>(world.space());
  const ShortestPathTree tree(graph, {4, 1});
  for (const Point to : {Point{4, 5}, Point{8, 8}, Point{6, 1}, Point{1, 9}, Point{5, 3}}) {
    const auto path = tree.path_to(to);
    const GraphSearchResult single = shortest_path(*graph, {4, 1}, Goal{to, {}});
    ASSERT_TRUE(path);
    EXPECT_EQ(path->length, single.path.length) << to.x << ' ' << to.y;
  }
}

TEST(ShortestPath, HoldsInMessyWorldsOffAllLattices) {
  std::size_t found = 0, none = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const test::MessyWorld messy = test::messy_world(seed);
    const FreeSpace space(World(messy.parts), messy.footprint);
    const VisibilityGraph graph(space);
    std::mt19937_64 engine(seed);
    const auto place = [&] { return Point{double(engine() % 1000) / 100, double(engine() % 1000) / 100}; };
    for (int k = 0; k < 4; ++k) {
      const Point from = place(), to = place();
      const Location at_from = space.locate(from), at_to = space.locate(to);
      if (at_from.kind == Location::Kind::outside || at_to.kind == Location::Kind::outside) continue;
      const GraphSearchResult there = shortest_path(graph, from, Goal{to, {}});
      const GraphSearchResult back = shortest_path(graph, to, Goal{from, {}}, GraphAlgorithm::dijkstra);
      ASSERT_EQ(there.status, back.status) << "seed " << seed;
      ASSERT_EQ(there.path.length, back.path.length) << "seed " << seed;
      if (there.status == SearchStatus::found) {
        const Verdict verdict = verify(there.path, space, from, Goal{to, {}});
        ASSERT_TRUE(verdict.valid) << "seed " << seed << ": " << verdict.reason;
        ++found;
      } else {
        ASSERT_NE(space.component(at_from.triangle), space.component(at_to.triangle)) << "seed " << seed;
        ASSERT_FALSE(space.separation(from, to).empty()) << "seed " << seed;
        ++none;
      }
    }
  }
  EXPECT_GT(found, 200u);
  EXPECT_GT(none, 20u);
}

/// A world, two places in it, and what becomes of both under a map of the plane.
struct Query {
  SmallWorld world;
  Point from, to;

  Query mapped(const std::function<Point(Point)>& map, bool mirrored = false) const {
    Query q = *this;
    const auto ring = [&](Ring& r) {
      for (Point& p : r) p = map(p);
      if (mirrored) std::reverse(r.begin(), r.end());
    };
    for (Segment& s : q.world.walls) s = {map(s.a), map(s.b)};
    for (Ring& r : q.world.solids) ring(r);
    ring(q.world.area);
    q.from = map(from);
    q.to = map(to);
    return q;
  }
};

std::optional<Length> length(const Query& q) {
  const FreeSpace space = q.world.space();
  for (const Point p : {q.from, q.to}) RC_PRE(space.locate(p).kind != Location::Kind::outside);
  const auto path = shortest_path(space, q.from, q.to);
  if (!path) return std::nullopt;
  return path->length;
}

Query any_query() {
  Query q{any_world({.side = 6, .walls = 8, .solids = 2, .thickness = any(0, 2) == 0 ? 0.25 : 0}), {}, {}};
  q.from = {any(0, 12) / 2.0, any(0, 12) / 2.0};
  q.to = {any(0, 12) / 2.0, any(0, 12) / 2.0};
  RC_LOG() << test::show(q.world) << '\n' << test::show(q.from) << test::show(q.to) << '\n';
  return q;
}

RC_GTEST_PROP(ShortestPath, IsAsLongFromEitherEnd, ()) {
  const Query q = any_query();
  RC_ASSERT(length(q) == length({q.world, q.to, q.from}));
}

RC_GTEST_PROP(ShortestPath, KeepsItsLengthUnderAQuarterTurn, ()) {
  const Query q = any_query();
  RC_ASSERT(length(q) == length(q.mapped([](Point p) { return Point{-p.y, p.x}; })));
}

RC_GTEST_PROP(ShortestPath, KeepsItsLengthInAMirror, ()) {
  const Query q = any_query();
  RC_ASSERT(length(q) == length(q.mapped([](Point p) { return Point{p.y, p.x}; }, true)));
}

RC_GTEST_PROP(ShortestPath, ScalesWithPowersOfTwo, ()) {
  Query q = any_query();
  const double factor = std::ldexp(1.0, any(-40, 40));
  Query scaled = q.mapped([factor](Point p) { return Point{p.x * factor, p.y * factor}; });
  scaled.world.thickness *= factor;
  const auto a = length(q), b = length(scaled);
  RC_ASSERT(a.has_value() == b.has_value());
  if (a) RC_ASSERT(a->value() * factor == b->value());
}

RC_GTEST_PROP(ShortestPath, IsNeverShortenedByAnotherWall, ()) {
  const Query q = any_query();
  Query more = q;
  more.world.walls.push_back(test::any_wall({.side = 6}));
  const auto a = length(q), b = length(more);
  RC_ASSERT(!b || (a && *a <= *b));
}

RC_GTEST_PROP(ShortestPath, IsValidOptimalInTheFullGraphAndAbsentOnlyBetweenComponents, ()) {
  const Query q = any_query();
  const FreeSpace space = q.world.space();
  for (const Point p : {q.from, q.to}) RC_PRE(space.locate(p).kind != Location::Kind::outside);
  const Goal goal{q.to, {}};
  const GraphSearchResult reduced = shortest_path(VisibilityGraph(space), q.from, goal);
  const GraphSearchResult full =
      shortest_path(VisibilityGraph(space, VisibilityKind::full), q.from, goal, GraphAlgorithm::dijkstra);
  RC_ASSERT(reduced.status == full.status);
  RC_ASSERT(reduced.path.length == full.path.length);
  if (reduced.status == SearchStatus::found) {
    const Verdict verdict = verify(reduced.path, space, q.from, goal);
    if (!verdict.valid) RC_FAIL(verdict.reason);
    RC_ASSERT(space.sees(q.from, q.to) == (reduced.path.points.size() <= 2));
  } else {
    RC_ASSERT(space.component(space.locate(q.from).triangle) != space.component(space.locate(q.to).triangle));
  }
}

}  // namespace
}  // namespace taut
