#include <taut/io/worlds/write_world.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/detail/cell_walls.h>

namespace taut {
namespace {

bool same_areas(const std::vector<Area>& a, const std::vector<Area>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].polygon != b[i].polygon) return false;
  return true;
}

// All but names, line numbers and the grid.
void check_same(const World& a, const World& b) {
  RC_ASSERT(same_areas(a.areas(), b.areas()));
  RC_ASSERT(same_areas(a.solids(), b.solids()));
  RC_ASSERT(a.boundary() == b.boundary());
  RC_ASSERT(a.openings() == b.openings());
  RC_ASSERT(a.start() == b.start());
  RC_ASSERT(a.goal().point == b.goal().point);
  RC_ASSERT(a.goal().room == b.goal().room);
  RC_ASSERT(a.walls().size() == b.walls().size());
  for (std::size_t i = 0; i < a.walls().size(); ++i) {
    RC_ASSERT(a.walls()[i].a == b.walls()[i].a);
    RC_ASSERT(a.walls()[i].b == b.walls()[i].b);
    RC_ASSERT(a.walls()[i].thickness == b.walls()[i].thickness);
  }
}

// Any double World takes, every bit pattern possible.
double any_coordinate() {
  const double value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  return std::abs(value) <= 1e70 && (value == 0 || std::abs(value) >= World::kSmallest)
             ? value + 0.0
             : static_cast<double>(*rc::gen::inRange(-100, 100)) / 8;
}

Point any_point() {
  const double x = any_coordinate();
  return {x, any_coordinate()};
}

/// As the bytes say: random ends are near walls by chance.
World as_written(const std::string& text, ReadOptions options = {}) {
  options.snap.what = Snap::What::nothing;
  return read_world(text, options);
}

WorldParts any_walls() {
  WorldParts parts;
  for (int i = *rc::gen::inRange(1, 20); i > 0; --i) {
    const Point a = any_point(), b = any_point();
    parts.walls.push_back({a, b, *rc::gen::element(0.0, 0.5, 1e-9), 0});
  }
  parts.walls.push_back({{0, 0}, {1, 1}, 0, 0});
  if (*rc::gen::arbitrary<bool>()) parts.start = any_point();
  if (*rc::gen::arbitrary<bool>())
    parts.goal.point = any_point();
  else if (*rc::gen::arbitrary<bool>())
    parts.goal.room = {{{0, 0}, {1, 1}}, {{1, 0}, {2.5, 1}}};
  if (*rc::gen::arbitrary<bool>()) parts.areas = {{{{{-1e-3, -5}, {8, 0}, {3, 9}}, {}}, 0}};
  return parts;
}

RC_GTEST_PROP(WriteSegments, ReadsBackTheSameWorld, ()) {
  const World world(any_walls());
  check_same(as_written(write_segments(world, {.comment = "two\nlines", .shift = {}})), world);
}

RC_GTEST_PROP(WriteGeoJson, ReadsBackTheSameWorld, ()) {
  WorldParts parts = any_walls();
  if (!parts.areas.empty()) {
    parts.boundary = *rc::gen::element(Boundary::limit, Boundary::walled);
    parts.areas[0].polygon.holes = {{{3, 2}, {3, 3}, {4, 2}}};
    parts.areas.push_back({{{{20, 20}, {30, 20}, {20, 30}}, {}}, 0});
  }
  parts.solids = {{{{{2, 1}, {4, 1}, {2, 7}}, {}}, 0}};
  const World world(parts);
  check_same(as_written(write_geojson(world)), world);
}

RC_GTEST_PROP(WriteWkt, ReadsBackTheSameWorld, ()) {
  WorldParts parts = any_walls();
  for (Wall& wall : parts.walls) wall.thickness = 0;
  if (!parts.start) parts.goal.point.reset();
  parts.goal.room.clear();
  parts.boundary = Boundary::walled;
  ReadOptions options;
  if (parts.areas.empty()) {
    parts.solids = {{{{{2, 1}, {4, 1}, {2, 7}}, {{{2.5, 2}, {2.5, 3}, {3, 2}}}}, 0}};
    options.polygons = ReadOptions::Polygons::obstacles;
  }
  const World world(parts);
  check_same(as_written(write_wkt(world), options), world);
}

GridMaze any_maze(int width, int height) {
  GridMaze maze = generate_backtracker(width, height, *rc::gen::arbitrary<std::uint64_t>());
  open_walls(maze, 0.3, *rc::gen::arbitrary<std::uint64_t>());
  maze.goal = centre_room(width, height);
  return maze;
}

GridMaze back(const std::string& bytes) { return *read_world(bytes).grid(); }

RC_GTEST_PROP(WriteMaze, ReadsBackTheSameMazeInEveryFormat, ()) {
  const GridMaze small = any_maze(*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12));
  RC_ASSERT(back(write_drawing(small)) == small);
  RC_ASSERT(back(write_num(small)) == small);
  const int even = 2 * *rc::gen::inRange(1, 9);
  const GridMaze square = any_maze(even, even);
  RC_ASSERT(back(write_cell_values(square)) == square);
  const GridMaze classic = any_maze(16, 16);
  RC_ASSERT(back(write_maz(classic)) == classic);
  const GridMaze half_size = any_maze(32, 32);
  RC_ASSERT(back(write_maz(half_size)) == half_size);
}

RC_GTEST_PROP(WriteMaze, KeepsMazesFromOpeningToOpening, ()) {
  const GridMaze maze = generate_biased_maze(16, 16, *rc::gen::arbitrary<std::uint64_t>());
  RC_ASSERT(back(write_drawing(maze)) == maze);
  RC_ASSERT(back(write_num(maze)) == maze);
  RC_ASSERT(back(write_maz(maze)) == maze);
  const World world = world_of(std::make_shared<const GridMaze>(maze));
  check_same(read_world(write_segments(world)), world);
  check_same(read_world(write_wkt(world)), world);
}

TEST(WriteMaze, KeepsStartAndGoalOfDrawings) {
  GridMaze maze(3, 2, true);
  maze.start = {1, 1};
  maze.goal = {{1, 1}, {2, 0}};
  EXPECT_EQ(back(write_drawing(maze)).start, (Cell{1, 1}));
  EXPECT_EQ(back(write_drawing(maze)).goal, (std::vector<Cell>{{1, 1}, {2, 0}}));
}

TEST(WriteSegments, IsNothingButWallsForAMazeFromOpeningToOpening) {
  GridMaze maze(2, 1, false);
  maze.set_wall({0, 0}, Side::west, false);
  maze.set_wall({1, 0}, Side::east, false);
  const World world = world_of(std::make_shared<const GridMaze>(maze));
  EXPECT_EQ(write_segments(world, {.comment = {}, .shift = {0.5, 0.5}}), "0.5 0.5 2.5 0.5\n0.5 1.5 2.5 1.5\n");
}

TEST(WriteSegments, KeepsTheRoomOfAGridMaze) {
  GridMaze maze(2, 1, true);
  maze.goal = {{1, 0}};
  EXPECT_EQ(write_segments(world_of(std::make_shared<const GridMaze>(maze))),
            "start 0.5 0.5\ngoal 1 0 2 1\n0 0 2 0\n0 1 2 1\n0 0 0 1\n1 0 1 1\n2 0 2 1\n");
}

TEST(WriteDrawing, PutsNorthOnTop) {
  GridMaze maze(2, 2, false);
  maze.set_wall({0, 0}, Side::east, true);
  maze.set_wall({1, 0}, Side::north, true);
  maze.goal = {{1, 1}};
  EXPECT_EQ(write_drawing(maze),
            "o---o---o\n"
            "|     G |\n"
            "o   o---o\n"
            "| S |   |\n"
            "o---o---o\n");
}

std::string refusal(const std::function<std::string()>& write) {
  try {
    return "written: " + write();
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(WriteWorld, RefusesWhatAFormatCannotHold) {
  GridMaze twenty(20, 20, true);
  twenty.goal = centre_room(20, 20);
  EXPECT_EQ(refusal([&] { return write_maz(twenty); }), "maz cannot hold a maze of 20 x 20, only 16 x 16 and 32 x 32");
  EXPECT_EQ(refusal([&] { return write_cell_values(GridMaze(5, 4, true)); }),
            "cells cannot hold a maze of 5 x 4, only squares of 2 to 256 a side");
  EXPECT_EQ(refusal([&] { return write_cell_values(generate_biased_maze(6, 6, 1)); }),
            "cells cannot hold openings of the border");
  twenty.goal = {{3, 3}};
  EXPECT_EQ(refusal([&] { return write_num(twenty); }), "num cannot hold a goal other than the room in the middle");
  twenty.goal.clear();
  EXPECT_EQ(refusal([&] { return write_drawing(twenty); }), "drawing cannot hold a maze without goal");

  const World plan = read_world("POLYGON ((0 0, 4 0, 4 4, 0 0))");
  EXPECT_EQ(refusal([&] { return write_segments(plan); }), "segments cannot hold floor plans; use geojson");
  EXPECT_EQ(refusal([&] { return write_world(plan, Format::drawing); }),
            "drawing cannot hold a world without limits, or one of floor plans");
  const World solid = read_world("POLYGON ((0 0, 4 0, 4 4, 0 0))", {.polygons = ReadOptions::Polygons::obstacles});
  EXPECT_EQ(refusal([&] { return write_segments(solid); }), "segments cannot hold solid polygons; use geojson");
  EXPECT_EQ(refusal([&] { return write_wkt(read_world("0 0 1 0 0.5")); }),
            "wkt cannot hold walls with a thickness; use geojson");
}

}  // namespace
}  // namespace taut
