#include <gtest/gtest.h>

#include <string>

#include <taut/io/worlds/read_world.h>

#include "support/refusal.h"

namespace taut {
namespace {

TEST(Blocks, AreCellsOfOneUnitWithTheirEndsInTheMiddle) {
  ReadNotes notes;
  const World world = read_world(
      "#####\n"
      "#S  #\n"
      "# # #\n"
      "#  G#\n"
      "#####\n",
      {}, &notes);
  EXPECT_EQ(notes.format, Format::blocks);
  EXPECT_EQ(world.box(), (Box{{0, 0}, {5, 5}}));
  EXPECT_EQ(world.solids().size(), 2U);
  EXPECT_EQ(world.start(), (Point{1.5, 3.5}));
  EXPECT_EQ(world.goal().point, (Point{3.5, 1.5}));
  EXPECT_FALSE(world.y_down());
}

TEST(Blocks, AreReadFromMatricesOfNoughtsAndOnes) {
  for (const char* text :
       {"010\n010\n000\n", "0 1 0\n0 1 0\n0 0 0", "[[0,1,0],\n [0,1,0],\n [0,0,0]]\n", "0,1,0\r\n0,1,0\r\n0,0,0"}) {
    ReadNotes notes;
    const World world = read_world(text, {}, &notes);
    EXPECT_EQ(notes.format, Format::blocks) << text;
    ASSERT_EQ(world.solids().size(), 1U) << text;
    EXPECT_EQ(world.solids()[0].polygon.outer.size(), 4U);
    EXPECT_EQ(world.box(), (Box{{0, 0}, {3, 3}}));
  }
}

// Rows of four numbers are walls, as they have always been.
TEST(Blocks, DoNotTakeWallsForCells) {
  EXPECT_EQ(detect_format("0 0 1 0\n1 0 1 1\n1 1 0 1\n0 1 0 0\n"), Format::segments);
  EXPECT_EQ(detect_format("# a comment\n0 0 1 0\n"), Format::segments);
  EXPECT_EQ(detect_format("[0 0 1 0]\n[1 0 1 1]\n"), Format::blocks);
}

TEST(Blocks, NameASecondEndAndWhatIsNoCell) {
  EXPECT_EQ(test::refusal_of([] { read_world("##\n#S\nS#\n"); }), "line 3: a second 'S' in column 1");
  EXPECT_EQ(test::refusal_of([] { read_world("##\n#x\n", {.format = Format::blocks}); }),
            "line 2: 'x' is no cell; cells are # or blank, S and G");
}

TEST(Blocks, EndShortRowsInFreeCells) {
  const World world = read_world("###\n#\n###\n");
  EXPECT_EQ(world.box(), (Box{{0, 0}, {3, 3}}));
  EXPECT_EQ(world.solids().size(), 1U);
}

}  // namespace
}  // namespace taut
