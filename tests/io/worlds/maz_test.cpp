#include <gtest/gtest.h>

#include <string>

#include <taut/io/worlds/read_world.h>

namespace taut {
namespace {

// 16 x 16, only the border and a wall right of the start.
std::string simple_maz() {
  std::string bytes(256, '\0');
  for (std::size_t i = 0; i < 16; ++i) {
    bytes[i * 16] = static_cast<char>(bytes[i * 16] | 4);
    bytes[i * 16 + 15] = static_cast<char>(bytes[i * 16 + 15] | 1);
    bytes[i] = static_cast<char>(bytes[i] | 8);
    bytes[240 + i] = static_cast<char>(bytes[240 + i] | 2);
  }
  bytes[0] = static_cast<char>(bytes[0] | 2);
  bytes[16] = static_cast<char>(bytes[16] | 8);
  return bytes;
}

TEST(Maz, ListsColumnsAndBitsOfWalls) {
  const World world = read_world(simple_maz());
  const GridMaze& maze = *world.grid();
  EXPECT_EQ(maze.width(), 16);
  EXPECT_TRUE(maze.wall({0, 0}, Side::east));
  EXPECT_FALSE(maze.wall({0, 1}, Side::east));
  EXPECT_EQ(maze.goal, (std::vector<Cell>{{7, 7}, {7, 8}, {8, 7}, {8, 8}}));
  EXPECT_TRUE(world.openings().empty());
}

TEST(Maz, IgnoresHighBits) {
  std::string bytes = simple_maz();
  bytes[100] = static_cast<char>(bytes[100] | 0xc0);
  EXPECT_EQ(*read_world(bytes).grid(), *read_world(simple_maz()).grid());
}

TEST(Maz, MayHaveOpeningsInItsBorder) {
  std::string bytes = simple_maz();
  bytes[3] = 0;
  const World world = read_world(bytes);
  EXPECT_FALSE(world.grid()->wall({0, 3}, Side::west));
  EXPECT_EQ(world.openings().size(), 1U);
  EXPECT_FALSE(world.grid()->goal.empty());
}

TEST(Maz, NamesBothCellsThatDisagree) {
  std::string bytes = simple_maz();
  bytes[16] = 4;
  try {
    read_world(bytes, {.source = "a.maz"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "a.maz: binary data of 256 bytes, but no .maz maze: cell (0,0) says wall to the right, cell (1,0) says open");
  }
}

TEST(Num, ListsCellsInAnyOrder) {
  const GridMaze maze = *read_world("1 0 1 1 1 0\n\n0 0 1 0 1 1\r\n2 0 1 1 1 1\n").grid();
  EXPECT_EQ(maze.width(), 3);
  EXPECT_EQ(maze.height(), 1);
  EXPECT_FALSE(maze.wall({0, 0}, Side::east));
  EXPECT_TRUE(maze.wall({1, 0}, Side::east));
  EXPECT_EQ(maze.goal, (std::vector<Cell>{{1, 0}}));
}

}  // namespace
}  // namespace taut
