#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <taut/geometry/free_space.h>
#include <taut/io/worlds/read_world.h>
#include <taut/io/worlds/write_world.h>

#include "support/paths.h"
#include "support/refusal.h"
#include "support/run_program.h"

namespace taut {
namespace {

using testing::HasSubstr;

World read(const std::string& text) { return read_world(text, {.source = "x"}); }

/// The same walls, limits and ends, as a format that holds everything says it.
void expect_same(const World& a, const World& b) {
  EXPECT_EQ(FreeSpace(a).polygons(), FreeSpace(b).polygons());
  EXPECT_EQ(a.boundary(), b.boundary());
  EXPECT_EQ(a.box(), b.box());
  EXPECT_EQ(a.start(), b.start());
  EXPECT_EQ(a.goal().point, b.goal().point);
  EXPECT_EQ(a.goal().room, b.goal().room);
}

std::string refusal(const std::string& world, Format format) {
  return test::refusal_of([&] { write_world(read(world), format); });
}

const std::string kMaze =
    "start 0.5 0.5\ngoal 1 1 2 2\n"
    "0 0 2 0\n2 0 2 2\n2 2 0 2\n0 2 0 0\n1 0 1 1\n";

TEST(WriteCells, WallsAlongUnitCellsAreADrawing) {
  const World world = read(kMaze);
  ASSERT_FALSE(world.grid());
  EXPECT_EQ(write_world(world, Format::drawing),
            "o---o---o\n"
            "|     G |\n"
            "o   o   o\n"
            "| S |   |\n"
            "o---o---o\n");
  expect_same(read(write_world(world, Format::drawing)), world);
}

TEST(WriteCells, MazesOfSegmentsComeBackFromEachFormatThatHoldsThem) {
  const World maze = read(test::contents(test::data_dir() / "mouse_16.maz"));
  const World segments = read(write_world(maze, Format::segments));
  for (const Format format : {Format::cell_values, Format::drawing, Format::maz, Format::num}) {
    EXPECT_EQ(write_world(segments, format), write_world(maze, format)) << name(format);
    expect_same(read(write_world(segments, format)), maze);
  }
}

TEST(WriteCells, RefusalSaysWhatADrawingWouldLose) {
  EXPECT_THAT(refusal(kMaze + "0 1 1 2\n", Format::drawing),
              HasSubstr("drawing cannot hold the wall (0, 1)-(1, 2), which runs along no sides of unit cells"));
  EXPECT_THAT(refusal(kMaze + "0 1 0.5 1\n", Format::num), HasSubstr("runs along no sides of unit cells"));
  EXPECT_THAT(refusal(kMaze + "0 1 1 1 0.1\n", Format::drawing), HasSubstr("cannot hold walls with a thickness"));
  EXPECT_THAT(refusal("boundary 0 0 2 2\nstart 0.5 0.6\ngoal 1 1 2 2\n1 0 1 1\n", Format::drawing),
              HasSubstr("an end at (0.5, 0.6), which is no middle of a cell"));
  EXPECT_THAT(refusal("boundary 0 0 2 2\nstart 0.5 0.5\ngoal 1.5 1.5\n1 0 1 1\n", Format::drawing),
              HasSubstr("cannot hold a goal point"));
  EXPECT_THAT(refusal("boundary 1 1 3 3\n2 1 2 2\n", Format::drawing),
              HasSubstr("limits that are no box of unit cells"));
}

TEST(WriteCells, MapsOfCellsComeBackAsMapsAndBlocks) {
  const World map = read(test::contents(test::data_dir() / "rooms_64x48.map"));
  expect_same(read(write_world(map, Format::movingai)), map);
  expect_same(read(write_world(map, Format::blocks)), map);
  const World blocks = read("#####\n#S..#\n#.#.#\n#..G#\n#####\n");
  EXPECT_EQ(write_world(blocks, Format::blocks), "#####\n#S..#\n#.#.#\n#..G#\n#####\n");
}

TEST(WriteCells, RefusalSaysWhatBlocksWouldLose) {
  const std::string blocks = "#####\n#S..#\n#.#.#\n#..G#\n#####\n";
  EXPECT_THAT(refusal(blocks, Format::movingai), HasSubstr("movingai cannot hold start and goal in a map"));
  EXPECT_THAT(refusal(kMaze, Format::blocks), HasSubstr("blocks cannot hold walls, only cells"));
  EXPECT_THAT(refusal("POLYGON ((0 0, 4 0, 4 4, 0 3, 0 0))\n", Format::blocks),
              HasSubstr("the side (4, 4)-(0, 3), which runs along no sides of unit cells"));
  EXPECT_THAT(refusal(blocks, Format::picture), HasSubstr("can be read, not written"));
}

}  // namespace
}  // namespace taut
