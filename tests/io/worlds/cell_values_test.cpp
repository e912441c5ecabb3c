#include <gtest/gtest.h>

#include <string>

#include <taut/io/worlds/read_world.h>

#include "support/refusal.h"

namespace taut {
namespace {

std::string message_of(const std::string& bytes) {
  return test::refusal_of([&] { read_world(bytes, {.format = Format::cell_values, .source = "cellar.csv"}); });
}

// o---o---o
// |       |
// o   o---o
// | S |   |   the right cell below is closed
// o---o---o
TEST(CellValues, ListColumnsFromTheLeftAndCellsFromTheBottom) {
  const World world = read_world("2\r\n1,6\r\n0, 8");
  const GridMaze& maze = *world.grid();
  EXPECT_EQ(maze.width(), 2);
  EXPECT_FALSE(maze.wall({0, 0}, Side::north));
  EXPECT_TRUE(maze.wall({0, 0}, Side::east));
  EXPECT_FALSE(maze.wall({0, 1}, Side::east));
  EXPECT_TRUE(maze.wall({1, 0}, Side::north));
  EXPECT_EQ(maze.start, (Cell{0, 0}));
  EXPECT_EQ(maze.goal.size(), 4U);
  EXPECT_EQ(world.start(), (Point{0.5, 0.5}));
}

TEST(CellValues, MayHaveAnOddNumberOfColumns) {
  const World world = read_world("3\n1,5,6\n2,2,10\n9,13,12\n");
  EXPECT_EQ(world.grid()->width(), 3);
  EXPECT_EQ(world.grid()->goal, (std::vector<Cell>{{1, 1}}));
  EXPECT_EQ(message_of("1\n0\n"), "cellar.csv:1: maze size '1' is not a whole number between 2 and 256");
}

TEST(CellValues, NamesBothCellsThatDisagree) {
  EXPECT_EQ(message_of("2\n1,6\n0,0\n"), "cellar.csv:3: cell (0,1) says open to the right, cell (1,1) says wall");
  EXPECT_EQ(message_of("2\n1,4\n0,8\n"), "cellar.csv:3: cell (0,1) says wall to the right, cell (1,1) says open");
  EXPECT_EQ(message_of("2\n0,6\n0,8\n"), "cellar.csv:2: cell (0,0) says wall upwards, cell (0,1) says open");
}

TEST(CellValues, CountBlankLinesAndComments) {
  EXPECT_EQ(message_of("# maze\n2\n\n1,6\n0,0\n"),
            "cellar.csv:5: cell (0,1) says open to the right, cell (1,1) says wall");
}

TEST(CellValues, HaveAClosedBorder) {
  EXPECT_EQ(message_of("2\n5,6\n0,8\n"), "cellar.csv:2: cell (0,0) is open downwards, but the border is closed");
}

TEST(CellValues, AreWholeNumbersFrom0To15) {
  EXPECT_EQ(message_of("2\n1,-6\n0,8\n"),
            "cellar.csv:2: value of cell (0,1) '-6' is not a whole number between 0 and 15");
  EXPECT_EQ(message_of("2\n1,6.0\n0,8\n"),
            "cellar.csv:2: value of cell (0,1) '6.0' is not a whole number between 0 and 15");
  EXPECT_EQ(message_of("2\n1,99999999999999999999\n0,8\n"),
            "cellar.csv:2: value of cell (0,1) '99999999999999999999' is not a whole number between 0 and 15");
  EXPECT_EQ(message_of("2\n1,6,\n0,8\n"), "cellar.csv:2: the line ends with a comma");
}

}  // namespace
}  // namespace taut
