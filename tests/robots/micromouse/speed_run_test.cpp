// Speed runs against a second search that knows turns only as curves, and times that another integrator finds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/micromouse/rules.h>
#include <taut/robots/micromouse/speed_run.h>
#include <cmath>
#include <vector>

#include "robots/micromouse/sound_run.h"

namespace taut::micromouse {
namespace {

using testing::HasSubstr;

GridMaze maze_of(const char* drawing) { return *read_world(drawing).grid(); }

TEST(SpeedRun, IsStraightWhereTheMazeIs) {
  const GridMaze maze = maze_of("o---o\n| G |\no   o\n|   |\no   o\n| S |\no---o\n");
  const auto run = speed_run(maze);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->drives.size(), 1U);
  EXPECT_NEAR(run->seconds, 2 * std::sqrt(0.36 / 10), 1e-12);
  EXPECT_NEAR(run->metres, 0.36, 1e-12);
}

TEST(SpeedRun, TurnsOnTheSpotWhereThereIsNoOtherWay) {
  const GridMaze maze = maze_of("o---o---o\n|       |\no   o---o\n| S   G |\no---o---o\n");
  const auto run = speed_run(maze);
  ASSERT_TRUE(run);
  EXPECT_EQ(name(run->drives.front()), "pivot");
  EXPECT_NEAR(run->seconds, 0.25 + 2 * std::sqrt(0.18 / 10), 1e-12);
}

TEST(SpeedRun, DrivesAStaircaseAsADiagonal) {
  GridMaze maze(6, 10, true);
  for (const Cell c : {Cell{0, 0}, Cell{0, 1}, Cell{5, 7}, Cell{5, 8}}) maze.set_wall(c, Side::north, false);
  for (int k = 0; k < 5; ++k) {
    maze.set_wall({k, k + 2}, Side::north, false);
    maze.set_wall({k, k + 3}, Side::east, false);
  }
  maze.goal = {{5, 9}};
  const auto run = speed_run(maze);
  ASSERT_TRUE(run);
  expect_sound(*run, maze, {});
  double diagonal = 0;
  for (const Drive& d : run->drives) diagonal += name(d) == "diagonal" ? d.metres : 0;
  EXPECT_NEAR(diagonal, 8 * 0.09 * kRoot, 1e-9);
}

TEST(SpeedRun, IsAbsentWithoutAWay) {
  EXPECT_FALSE(speed_run(maze_of("o---o---o\n|   | G |\no   o---o\n| S |   |\no---o---o\n")).has_value());
  EXPECT_FALSE(
      speed_run(maze_of("o---o---o\n|   | G |\no   o---o\n| S |   |\no---o---o\n"), {}, Aim::fewest_cells).has_value());
}

TEST(SpeedRun, IsWhatASecondSearchOverCurvesFinds) {
  SpeedModel lame, nimble, round;
  round.turns = {{{0.5, {}}, {0.5, {}}, {0.5, {}}, {0.5, {}}, {1.3, 0.1}, {0.5, {}}}};
  lame.straight = {2, 3, 1.7};
  lame.diagonal = {2, 2, 1.6};
  nimble.turns = {{{1.4, {}}, {1.4, 0.1}, {1.4, {}}, {1.4, {}}, {1.4, {}}, {1.4, {}}}};
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const SpeedModel& model : {SpeedModel{}, lame, nimble, round}) {
      const GridMaze maze = random_maze(4 + static_cast<int>(seed % 3), 5, seed, seed % 2 == 0 ? 0.5 : 0.15);
      const auto run = speed_run(maze, model);
      ASSERT_TRUE(run);
      expect_sound(*run, maze, model);
      EXPECT_NEAR(run->seconds, *SlowSearch(maze, model).seconds(), 1e-4) << "seed " << seed;
    }
}

TEST(SpeedRun, IsSoundAndNeverSlowerThanTheShortest) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const GridMaze maze = random_maze(16, 16, seed, 0.2);
    const auto fastest = speed_run(maze), shortest = speed_run(maze, {}, Aim::fewest_cells);
    ASSERT_TRUE(fastest && shortest);
    expect_sound(*fastest, maze, {});
    expect_sound(*shortest, maze, {});
    EXPECT_LE(fastest->seconds, shortest->seconds);
    EXPECT_GE(fastest->cells.size(), shortest->cells.size());
  }
}

}  // namespace
}  // namespace taut::micromouse
