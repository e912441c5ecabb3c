#include <gtest/gtest.h>

#include <string>

#include <taut/io/worlds/read_world.h>

#include "support/refusal.h"

namespace taut {
namespace {

GridMaze maze_of(const std::string& bytes) { return *read_world(bytes, {.format = Format::drawing}).grid(); }

std::string message_of(const std::string& bytes) {
  return test::refusal_of([&] { maze_of(bytes); });
}

const char* const kMaze =
    "o---o---o---o\n"
    "|     G | G |\n"
    "o---o   o   o\n"
    "| S         |\n"
    "o---o---o---o\n";

TEST(Drawing, HasNorthOnTop) {
  const GridMaze maze = maze_of(kMaze);
  EXPECT_EQ(maze.width(), 3);
  EXPECT_EQ(maze.height(), 2);
  EXPECT_EQ(maze.start, (Cell{0, 0}));
  EXPECT_EQ(maze.goal, (std::vector<Cell>{{1, 1}, {2, 1}}));
  EXPECT_TRUE(maze.wall({0, 0}, Side::north));
  EXPECT_FALSE(maze.wall({1, 0}, Side::north));
  EXPECT_TRUE(maze.wall({1, 1}, Side::east));
  EXPECT_FALSE(maze.wall({0, 0}, Side::east));
}

TEST(Drawing, ReadsTheSameWithOtherPostsCommentsAndLineEnds) {
  std::string plus = kMaze;
  for (char& c : plus)
    if (c == 'o') c = '+';
  EXPECT_EQ(maze_of(plus), maze_of(kMaze));
  std::string crlf = "# a maze\r\n";
  for (char c : std::string(kMaze)) crlf += c == '\n' ? "   # row\r\n" : std::string(1, c);
  EXPECT_EQ(maze_of(crlf + "\r\nfinal of 1999\r\n"), maze_of(kMaze));
  std::string bare = kMaze;
  bare.pop_back();
  EXPECT_EQ(maze_of(bare), maze_of(kMaze));
}

TEST(Drawing, HasCellsOfAnySize) {
  const char* const narrow =
      "+-+-+-+\n"
      "|  G|G|\n"
      "+-+ + +\n"
      "|S    |\n"
      "+-+-+-+\n";
  const char* const large =
      "+--+--+--+\n"
      "|     |  |\n"
      "|   G | G|\n"
      "+--+  +  +\n"
      "|S       |\n"
      "|        |\n"
      "+--+--+--+\n";
  EXPECT_EQ(maze_of(narrow), maze_of(kMaze));
  EXPECT_EQ(maze_of(large), maze_of(kMaze));
  EXPECT_EQ(detect_format(large), Format::drawing);
  EXPECT_EQ(message_of("+--+--+\n|  |  |\n|     |\n+--+--+\n"), "line 3: column 4: ' ' where the wall above it is '|'");
  EXPECT_EQ(message_of("+--+--+\n|  |  |\n+--+- +\n"), "line 3: column 5: '-' begins no wall ('---', '   ' or ' . ')");
}

TEST(Drawing, TakesCutOffLineEndsForBlanks) {
  const GridMaze maze = maze_of("o---o---o\n|\no---o---o\n");
  EXPECT_FALSE(maze.wall({0, 0}, Side::east));
  EXPECT_FALSE(maze.wall({1, 0}, Side::east));
}

TEST(Drawing, TakesUnknownWallsForOpenInsideAndClosedOnTheBorder) {
  const GridMaze maze = maze_of("o---o . o\n|   .   .\no . o---o\n|       |\no---o---o\n");
  EXPECT_FALSE(maze.wall({0, 1}, Side::east));
  EXPECT_FALSE(maze.wall({0, 1}, Side::south));
  EXPECT_TRUE(maze.wall({1, 1}, Side::north));
  EXPECT_TRUE(maze.wall({1, 1}, Side::east));
}

TEST(Drawing, HasItsGoalInTheMiddleUnlessMarked) {
  EXPECT_EQ(maze_of("o---o---o---o\n|           |\no---o---o---o\n").goal, (std::vector<Cell>{{1, 0}}));
  EXPECT_EQ(maze_of("o---o---o\n|       |\no   o   o\n|       |\no---o---o\n").goal.size(), 4U);
}

TEST(Drawing, WithoutMarksGoesFromOpeningToOpening) {
  const World world = read_world("o---o---o\n         \no---o---o\n");
  EXPECT_TRUE(world.grid()->goal.empty());
  EXPECT_EQ(world.start(), (Point{0, 0.5}));
  EXPECT_EQ(world.goal().point, (Point{2, 0.5}));
}

TEST(Drawing, NamesLineAndColumnOfWhatItCannotRead) {
  EXPECT_EQ(message_of("o---o---o\n|       |\no   o-- o\n|       |\no---o---o\n"),
            "line 3: column 6: '-' begins no wall ('---', '   ' or ' . ')");
  EXPECT_EQ(message_of("o---o\n"), "line 1: the drawing has no row of cells");
  EXPECT_EQ(message_of("o---o\n|   |\n"), "line 2: this row does not belong to the drawing above");
  EXPECT_EQ(message_of("o---o\n|   ||\no---o\n"), "line 2: the row is longer than the 1 cells of the first row");
}

}  // namespace
}  // namespace taut
