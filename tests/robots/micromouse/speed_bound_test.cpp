#include <taut/robots/micromouse/speed_bound.h>

#include <gtest/gtest.h>

#include <cmath>

#include <taut/geometry/maze_generator.h>
#include <taut/robots/micromouse/speed_run.h>

namespace taut::micromouse {
namespace {

/// A corridor to the north.
GridMaze corridor(int cells) {
  GridMaze maze(1, cells, false);
  maze.goal = {{0, cells - 1}};
  return maze;
}

TEST(SpeedBound, IsTheTimeOfAStraight) {
  for (const int cells : {2, 5, 30}) {
    const auto run = speed_run(corridor(cells));
    const auto bound = speed_bound(corridor(cells));
    ASSERT_TRUE(run && bound);
    EXPECT_LE(bound->seconds, run->seconds);
    EXPECT_NEAR(bound->seconds, run->seconds, 1e-9);
    EXPECT_NEAR(bound->metres, 0.18 * (cells - 1), 1e-9);
  }
}

TEST(SpeedBound, IsNeverAboveTheFastestRun) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    GridMaze maze = generate_backtracker(8, 8, seed);
    open_walls(maze, 0.3, seed);
    open_centre_room(maze);
    const auto run = speed_run(maze);
    const auto bound = speed_bound(maze);
    ASSERT_EQ(run.has_value(), bound.has_value());
    if (!run) continue;
    EXPECT_LT(bound->seconds, run->seconds) << seed;
    EXPECT_LT(bound->metres, run->metres) << seed;
    EXPECT_GT(bound->seconds, run->seconds / 5) << seed;
  }
}

TEST(SpeedBound, GoesBySpeedAloneWhereTurnsAreQuickerThanTheirSpeed) {
  SpeedModel model;
  model.turns[0].time = 0.05;  // 0.14 m: 2.8 m/s in the mean, at 0.9
  const auto bound = speed_bound(corridor(30), model);
  ASSERT_TRUE(bound);
  EXPECT_NEAR(bound->seconds, 29 * 0.18 / 4, 1e-9);
}

TEST(SpeedBound, IsAbsentWithoutAWay) {
  GridMaze maze = corridor(3);
  maze.set_wall({0, 1}, Side::north, true);
  EXPECT_FALSE(speed_bound(maze));
}

}  // namespace
}  // namespace taut::micromouse
