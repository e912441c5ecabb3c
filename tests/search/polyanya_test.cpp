#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include <fmt/format.h>

#include <taut/geometry/maze_generator.h>
#include <taut/geometry/written.h>
#include <taut/io/worlds/query_lines.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/paths.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::box_ring;
using test::SmallWorld;

std::string length_of(const FreeSpace& space, Point from, const Goal& to) {
  const GraphSearchResult result = shortest_path(Polyanya(space), from, to);
  return result.status == SearchStatus::found ? result.path.length.decimals(6) : "none";
}
std::string length_of(const SmallWorld& world, Point from, Point to) {
  return length_of(world.space(), from, {to, {}});
}

TEST(Polyanya, GoesStraightWhereNothingIsInTheWay) { EXPECT_EQ(length_of(SmallWorld{}, {1, 1}, {4, 5}), "5.000000"); }

TEST(Polyanya, GoesAroundTheFreeEndOfAWall) {
  EXPECT_EQ(length_of({.walls = {{{5, 0}, {5, 6}}}, .solids = {}}, {2, 2}, {8, 2}), "10.000000");
  EXPECT_EQ(length_of({.walls = {{{5, 0}, {5, 6}}}, .solids = {}}, {5, 2}, {5, 2}), "0.000000");
}

TEST(Polyanya, TurnsRightBackAlongTheOtherSideOfAWall) {
  const SmallWorld world{.walls = {{{0, 5}, {6, 5}}}, .solids = {box_ring(0, 3, 6, 4), box_ring(0, 6, 6, 7)}};
  EXPECT_EQ(length_of(world, {1, 4.5}, {1, 5.5}), "10.049876");
}

TEST(Polyanya, DoesNotSlipThroughAJoint) {
  EXPECT_EQ(length_of({.walls = {{{0, 3}, {5, 5}}, {{5, 5}, {10, 3}}}, .solids = {}}, {5, 2}, {5, 8}), "none");
  EXPECT_EQ(length_of({.walls = {}, .solids = {box_ring(0, 0, 5, 5), box_ring(5, 5, 10, 10)}}, {8, 2}, {2, 8}), "none");
}

TEST(Polyanya, LeavesAWallToBothSides) {
  const SmallWorld world{.walls = {{{2, 5}, {8, 5}}}, .solids = {}};
  EXPECT_EQ(length_of(world, {5, 5}, {5, 7}), "2.000000");
  EXPECT_EQ(length_of(world, {5, 5}, {5, 3}), "2.000000");
  EXPECT_EQ(length_of(world, {5, 3}, {5, 5}), "2.000000");
  EXPECT_EQ(length_of(world, {2, 5}, {8, 5}), "6.000000");
}

TEST(Polyanya, EndsWhereItEntersTheRoom) {
  const World world = read_world(
      "o---o---o---o\n"
      "| S       G |\n"
      "o---o---o---o\n");
  EXPECT_EQ(length_of(FreeSpace(world), *world.start(), world.goal()), "1.500000");
}

TEST(Polyanya, SeesNothingThroughAPortalInLineWithTheStart) {
  // The room lies under the wall that the start is on; the way in is around the wall's end.
  const SmallWorld world{.walls = {{{0, 0}, {5, 2}}, {{0, 2}, {4, 2}}, {{0, 2}, {4, 0}}},
                         .solids = {box_ring(0, 1, 1, 2)},
                         .area = box_ring(0, 0, 6, 6)};
  EXPECT_EQ(length_of(world.space(), {0, 2}, {{}, {{{0, 1}, {1, 2}}, {{1, 1}, {2, 2}}}}), "6.000000");
}

TEST(Polyanya, RefusesEndsInSolids) {
  PolyanyaSearch search{Polyanya(SmallWorld{.walls = {}, .solids = {box_ring(1, 1, 3, 3)}}.space())};
  EXPECT_THROW(search.find({2, 2}, Point{5, 5}), InputError);
  EXPECT_THROW(search.find({5, 5}, Point{2, 2}), InputError);
  EXPECT_THROW(search.find({5, 5}, Point{11, 2}), InputError);
  EXPECT_EQ(search.find({5, 5}, Point{6, 5}), SearchStatus::found) << "and can be asked again";
}

TEST(Polyanya, DecidesTiesExactly) {
  // Two ways around a block: the right one is shorter by 2^-40.
  const double less = 0x1p-40;
  const SmallWorld world{.walls = {}, .solids = {box_ring(3, 4, 7 - less, 6)}};
  const GraphSearchResult result = shortest_path(Polyanya(world.space()), {5, 1}, {Point{5, 9}, {}});
  ASSERT_EQ(result.path.points.size(), 4U);
  EXPECT_EQ(result.path.points[1].x, 7 - less);
}

TEST(Polyanya, StopsAtItsLimit) {
  auto grid = std::make_shared<GridMaze>(generate_backtracker(30, 30, 1));
  open_walls(*grid, 0.5, 1);
  PolyanyaSearch search{Polyanya(FreeSpace(world_of(std::move(grid))))};
  EXPECT_EQ(search.find({0.5, 0.5}, Point{29.5, 29.5}, {.expansions = 5}), SearchStatus::stopped);
  EXPECT_EQ(search.expanded(), 5U);
  EXPECT_EQ(search.find({0.5, 0.5}, Point{29.5, 29.5}), SearchStatus::found);
}

TEST(Polyanya, LooksAtNothingButTheCorridorOfAPerfectMaze) {
  PolyanyaSearch search{Polyanya(FreeSpace(world_of(std::make_shared<GridMaze>(generate_backtracker(100, 100, 1)))))};
  ASSERT_EQ(search.find({0.5, 0.5}, Point{1.5, 0.5}), SearchStatus::found);
  const std::size_t turns = search.points().size();
  EXPECT_GT(turns, 2U);
  EXPECT_EQ(search.expanded(), 1U);
}

TEST(Polyanya, NeverLooksForAGoalInAnotherComponent) {
  PolyanyaSearch search{Polyanya(SmallWorld{.walls = {{{5, 0}, {5, 10}}, {{2, 0}, {2, 9}}}, .solids = {}}.space())};
  EXPECT_EQ(search.find({1, 1}, Point{8, 2}), SearchStatus::none);
  EXPECT_EQ(search.expanded(), 1U);
}

TEST(Polyanya, LooksAtLessWithLandmarksWherePathsWind) {
  auto grid = std::make_shared<GridMaze>(generate_backtracker(60, 60, 1));
  open_walls(*grid, 0.05, 1);
  const Polyanya plain{FreeSpace(world_of(std::move(grid)))};
  PolyanyaSearch without(plain), with(plain.with_landmarks());
  std::size_t expanded_without = 0, expanded_with = 0;
  for (int n = 0; n < 60; ++n) {
    const Point from{n + 0.5, 0.5}, to{59.5 - n, 59.5};
    ASSERT_EQ(without.find(from, to), SearchStatus::found);
    ASSERT_EQ(with.find(from, to), SearchStatus::found);
    ASSERT_EQ(with.result().path.length, without.result().path.length);
    expanded_without += without.expanded();
    expanded_with += with.expanded();
  }
  EXPECT_LT(expanded_with * 3, expanded_without * 2);
}

/// Random pairs in a world: exactly as long as in the visibility graph, and checked.
void expect_agreement(const World& read, std::size_t pairs, const std::string& file) {
  const FreeSpace space(read);
  const VisibilityGraph graph(space);
  PolyanyaSearch search{Polyanya(space)};
  const World& world = space.world();
  if (world.start() && (world.goal().point || !world.goal().room.empty())) {
    search.find(*world.start(), world.goal());
    const GraphSearchResult expected = shortest_path(graph, *world.start(), world.goal());
    ASSERT_EQ(search.result().status, expected.status) << file;
    EXPECT_EQ(search.result().path.length, expected.path.length) << file;
  }
  std::mt19937_64 engine(7);
  const auto place = [&] {
    const Box box = world.box();
    const double x = static_cast<double>(engine() % 1025) / 1024, y = static_cast<double>(engine() % 1025) / 1024;
    return Point{box.min.x + x * (box.max.x - box.min.x), box.min.y + y * (box.max.y - box.min.y)};
  };
  for (std::size_t n = 0; n < pairs; ++n) {
    const Point from = place(), to = place();
    if (space.locate(from).kind == Location::Kind::outside || space.locate(to).kind == Location::Kind::outside)
      continue;
    const GraphSearchResult expected = shortest_path(graph, from, {to, {}});
    ASSERT_EQ(search.find(from, to), expected.status) << file;
    if (expected.status != SearchStatus::found) continue;
    const Path path = search.result().path;
    EXPECT_EQ(path.length, expected.path.length) << fmt::format("{}: {} {} to {} {}", file, from.x, from.y, to.x, to.y);
    EXPECT_TRUE(n % 8 != 0 || verify(path, space, from, {to, {}}).valid) << file;
  }
}

void expect_agreement(const std::filesystem::path& file, std::size_t pairs) {
  expect_agreement(read_world_file(file.string(), {}), pairs, file.string());
}

TEST(Polyanya, IsAsLongAsInTheVisibilityGraphInAllFilesOfOurs) {
  for (const auto& entry : std::filesystem::directory_iterator(test::data_dir())) {
    const std::string kind = entry.path().extension().string();
    const bool world = entry.is_regular_file() && kind != ".md" && kind != ".csv" && kind != ".scen" &&
                       kind != ".chase" && kind != ".json" && kind != ".pgm";
    ReadOptions options;
    options.crossings = Crossings::even_odd;  // one is broken
    const std::string file = entry.path().string();
    if (world) expect_agreement(read_world_file(file, options), 40, file);
  }
}

/// With loops, and the goal room in the middle.
GridMaze mouse_maze(int side, std::uint64_t seed) {
  GridMaze maze = generate_backtracker(side, side, seed);
  open_walls(maze, 0.12, seed);
  maze.goal = {{side / 2 - 1, side / 2 - 1}, {side / 2, side / 2 - 1}, {side / 2 - 1, side / 2}, {side / 2, side / 2}};
  return maze;
}

TEST(Polyanya, IsAsLongAsInTheVisibilityGraphInManyMouseMazes) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    expect_agreement(world_of(std::make_shared<GridMaze>(mouse_maze(seed % 2 == 0 ? 16 : 12, seed))), 10,
                     "seed " + std::to_string(seed));
  for (const char* folder : {"micromouse", "prm"})
    for (const auto& file : test::shared_files(folder)) expect_agreement(file, 10);
}

TEST(Polyanya, IsAsLongAsInTheVisibilityGraphOnGridMaps) {
  for (const char* file : {"rooms_64x48.map", "random_64x64.map"}) expect_agreement(test::data_dir() / file, 500);
  if (const auto shared = test::shared_data_dir()) expect_agreement(*shared / "movingai" / "arena.map.gz", 500);
}

// The reference on our map is a graph of all pairs of corners that see each other, with nothing left out.
TEST(Polyanya, GivesTheLengthsOfTheFullGraphOnAGridMap) {
  const FreeSpace space(read_world_file((test::data_dir() / "corridors_41x31.map").string(), {}));
  const VisibilityGraph full(space, VisibilityKind::full);
  PolyanyaSearch search{Polyanya(space)};
  std::mt19937_64 engine(3);
  std::size_t compared = 0;
  while (compared < 200) {
    const auto place = [&] {
      return Point{static_cast<int>(engine() % 41) + 0.5, static_cast<int>(engine() % 31) + 0.5};
    };
    const Point from = place(), to = place();
    if (space.locate(from).kind == Location::Kind::outside || space.locate(to).kind == Location::Kind::outside)
      continue;
    const GraphSearchResult expected = shortest_path(full, from, {to, {}});
    ASSERT_EQ(search.find(from, to), expected.status);
    ++compared;
    if (expected.status == SearchStatus::found) {
      EXPECT_EQ(search.result().path.length, expected.path.length) << from.x << ' ' << from.y;
    }
  }
}

TEST(Polyanya, GivesTheLengthsOfTheReferenceOnGridMapsOfOthers) {
  const auto shared = test::shared_data_dir();
  if (!shared) return;  // the test above stands for it
  std::size_t compared = 0;
  for (const char* map : {"arena", "brc202d", "maze512-32-0", "maze512-8-0", "maze512-8-0-braid20"}) {
    const std::filesystem::path file = *shared / "movingai" / map;
    PolyanyaSearch search{Polyanya(FreeSpace(read_world_file(file.string() + ".map.gz", {})))};
    std::ifstream queries(file.string() + ".queries");
    std::string line;
    for (int number = 1; std::getline(queries, line); ++number) {
      const auto query = query_line(line, file.string(), number);
      if (!query) continue;
      ASSERT_EQ(search.find(query->from, query->to), SearchStatus::found);
      EXPECT_NEAR(search.length(), *query->expected, 1e-6) << map << ':' << number;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 5000U);
}

TEST(Polyanya, FindsTenThousandPathsAmongPolygonsAsLongAsTheVisibilityGraph) {
  std::mt19937_64 engine(2024);
  const auto unit = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::size_t compared = 0;
  for (int round = 0; compared < 10'000; ++round) {
    SmallWorld world;
    world.area = box_ring(0, 0, 20, 20);
    for (int n = 0; n < 40; ++n) {
      // A star around a place: simple, seldom convex, overlapping others.
      const double x = unit() * 20, y = unit() * 20;
      const int corners = 3 + static_cast<int>(engine() % 6);
      Ring ring;
      for (int k = 0; k < corners; ++k) {
        const double angle = 6.283185307179586 * (k + 0.8 * unit()) / corners, r = 0.3 + 1.5 * unit();
        const double px = x + r * std::cos(angle), py = y + r * std::sin(angle);
        ring.push_back({px, py});
      }
      if (written::ring_orientation(ring) > 0) world.solids.push_back(ring);
    }
    FreeSpace space = [&] {
      for (;; world.solids.pop_back()) try {
          return world.space();
        } catch (const InputError&) {
        }
    }();
    const VisibilityGraph graph(space);
    // On merged polygons and on the bare triangles by turns.
    PolyanyaSearch search{Polyanya(space, round % 2 == 0 ? navmesh(space) : triangle_navmesh(space))};
    for (int n = 0; n < 250; ++n) {
      const double x = unit() * 20, y = unit() * 20, u = unit() * 20, v = unit() * 20;
      const Point from{x, y}, to{u, v};
      if (space.locate(from).kind == Location::Kind::outside || space.locate(to).kind == Location::Kind::outside)
        continue;
      const GraphSearchResult expected = shortest_path(graph, from, {to, {}});
      ASSERT_EQ(search.find(from, to), expected.status) << "round " << round << ", query " << n;
      ++compared;
      if (expected.status != SearchStatus::found) continue;
      EXPECT_EQ(search.result().path.length, expected.path.length) << "round " << round << ", query " << n;
    }
  }
}

}  // namespace
}  // namespace taut
