#include <taut/geometry/maze_generator.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/geometry/errors.h>

namespace taut {
namespace {

// Reachable cells and standing interior walls; a perfect maze reaches all cells and has (w - 1)(h - 1) walls.
struct Census {
  int reached = 0;
  int walls = 0;
};

Census census(const GridMaze& maze) {
  Census result;
  std::set<Cell> seen{{0, 0}};
  std::vector<Cell> open{{0, 0}};
  while (!open.empty()) {
    const Cell c = open.back();
    open.pop_back();
    ++result.reached;
    for (Side side : kSides) {
      const Cell next = GridMaze::neighbour(c, side);
      if (maze.contains(next) && !maze.wall(c, side) && seen.insert(next).second) open.push_back(next);
    }
  }
  for (int x = 0; x < maze.width(); ++x)
    for (int y = 0; y < maze.height(); ++y) {
      result.walls += x + 1 < maze.width() && maze.wall({x, y}, Side::east);
      result.walls += y + 1 < maze.height() && maze.wall({x, y}, Side::north);
    }
  return result;
}

RC_GTEST_PROP(MazeGenerator, MakesPerfectMazes, ()) {
  const int width = *rc::gen::inRange(1, 30), height = *rc::gen::inRange(1, 30);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  for (const GridMaze& maze : {generate_biased_maze(height, width, seed), generate_backtracker(width, height, seed)}) {
    RC_ASSERT(maze.width() == width && maze.height() == height);
    const Census c = census(maze);
    RC_ASSERT(c.reached == width * height);
    RC_ASSERT(c.walls == (width - 1) * (height - 1));
  }
}

TEST(MazeGenerator, OpensTheBiasedMazeAtTheFirstAndTheLastCell) {
  const GridMaze maze = generate_biased_maze(5, 7, 1);
  EXPECT_FALSE(maze.wall({0, 0}, Side::west));
  EXPECT_FALSE(maze.wall({6, 4}, Side::east));
  EXPECT_TRUE(maze.wall({0, 1}, Side::west));
  EXPECT_TRUE(maze.goal.empty());
}

TEST(MazeGenerator, IsTheSameForTheSameSeedOnly) {
  EXPECT_EQ(generate_biased_maze(20, 30, 7), generate_biased_maze(20, 30, 7));
  EXPECT_NE(generate_biased_maze(20, 30, 7), generate_biased_maze(20, 30, 8));
  EXPECT_EQ(generate_backtracker(20, 30, 7), generate_backtracker(20, 30, 7));
  EXPECT_NE(generate_backtracker(20, 30, 7), generate_backtracker(20, 30, 8));
}

// Share of removed walls between cells of one block that are vertical (left-right moves).
double horizontal_moves(const GridMaze& maze, int x0, int y0, int side) {
  int horizontal = 0, all = 0;
  for (int x = x0; x < x0 + side; ++x)
    for (int y = y0; y < y0 + side; ++y) {
      const bool east = x + 1 < x0 + side && !maze.wall({x, y}, Side::east);
      const bool north = y + 1 < y0 + side && !maze.wall({x, y}, Side::north);
      horizontal += east;
      all += east + north;
    }
  return static_cast<double>(horizontal) / all;
}

TEST(MazeGenerator, RunsAcrossAndAlongInTurnsOfBlocks) {
  const GridMaze maze = generate_biased_maze(36, 36, 3);  // blocks of 12; oe = row * col + col
  EXPECT_LT(horizontal_moves(maze, 0, 0, 12), 0.5);       // 1 * 1 + 1 is even: up and down
  EXPECT_GT(horizontal_moves(maze, 0, 12, 12), 0.5);      // 2 * 1 + 1 is odd: left and right
  EXPECT_LT(horizontal_moves(maze, 12, 0, 12), 0.5);      // 1 * 2 + 2
}

TEST(MazeGenerator, OpensTheShareOfWallsAskedFor) {
  GridMaze maze = generate_backtracker(21, 31, 5);
  const int before = census(maze).walls;
  ASSERT_EQ(before, 600);
  open_walls(maze, 0.1, 1);
  EXPECT_EQ(census(maze).walls, 540);
  EXPECT_TRUE(maze.wall({0, 0}, Side::west));
  open_walls(maze, 1, 1);
  EXPECT_EQ(census(maze).walls, 0);
  GridMaze same = generate_backtracker(21, 31, 5);
  open_walls(same, 0, 1);
  EXPECT_EQ(same, generate_backtracker(21, 31, 5));
}

TEST(MazeGenerator, RefusesSizesAndSharesThatMakeNoSense) {
  EXPECT_THROW(generate_biased_maze(0, 5, 1), InputError);
  EXPECT_THROW(generate_backtracker(5, 20001, 1), InputError);
  GridMaze maze(3, 3, true);
  EXPECT_THROW(open_walls(maze, -0.1, 1), InputError);
  EXPECT_THROW(open_walls(maze, 1.5, 1), InputError);
}

TEST(Draws, AreFixedForever) {
  Draws draws(1);
  const std::vector<std::uint32_t> first{draws.below(1000), draws.below(1000), draws.below(1000)};
  EXPECT_EQ(first, (std::vector<std::uint32_t>{133, 136, 451}));
  EXPECT_DOUBLE_EQ(Draws(1).unit(), 0.13387664401253274);
}

TEST(Draws, HitEveryValueAboutEquallyOften) {
  Draws draws(5);
  std::vector<int> hits(7);
  for (int i = 0; i < 70000; ++i) ++hits[draws.below(7)];
  for (int h : hits) EXPECT_NEAR(h, 10000, 400);
}

}  // namespace
}  // namespace taut
