// Runs at any speeds and their bound, against all lines of small mazes and against steady runs.
#include <taut/robots/micromouse/free_speed_run.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include <taut/io/worlds/read_world.h>

#include "robots/micromouse/every_line.h"
#include "robots/micromouse/sound_run.h"
#include "robots/micromouse/support.h"

namespace taut::micromouse {
namespace {

SpeedModel lame() {
  SpeedModel model;
  model.straight = {2, 3, 1.7};
  model.diagonal = {2, 2, 1.6};
  return model;
}

SpeedModel nimble() {
  SpeedModel model;
  model.turns = {{{1.4, {}}, {1.4, 0.1}, {1.4, {}}, {1.4, {}}, {1.4, {}}, {1.4, {}}}};
  return model;
}

/// How many random mazes: a few, or as many as TAUT_SPEED_MAZES says.
std::uint64_t mazes() {
  const char* const asked = std::getenv("TAUT_SPEED_MAZES");
  return asked ? std::stoull(asked) : 40;
}

/// So near is a bound to its run; and grids of slices to what they stand for.
constexpr double kNear = 0.99, kSlices = 1e-3;

TEST(FreeSpeedRun, IsTheTimeOfAStraight) {
  GridMaze corridor(1, 5, false);
  corridor.goal = {{0, 4}};
  const auto free = free_speed_run(corridor);
  ASSERT_TRUE(free);
  EXPECT_NEAR(free->run.seconds, 2 * std::sqrt(4 * 0.18 / 10), 1e-12);
  EXPECT_NEAR(free->bound, free->run.seconds, 1e-9);
}

TEST(FreeSpeedRun, BrakesOnTheStraightEndsOfATurn) {
  constexpr Spot kBegin{1, 1}, kTurn{1, 7}, kBack{3, 7}, kEnd{3, 1};
  SpeedRun run;
  run.drives.push_back({Drive::Kind::straight, {}, kBegin, kTurn, 0, 0, 0, 0, 0, 0.54});
  run.drives.push_back({Drive::Kind::turn, Turn::turn_180, kTurn, kBack, 0, 4, 0, 0, 0, length(Turn::turn_180) * 0.09});
  run.drives.push_back({Drive::Kind::straight, {}, kBack, kEnd, 4, 4, 0, 0, 0, 0.54});
  const Drive turn = at_full_speed(run).drives[1];
  EXPECT_NEAR(turn.speed_in, std::sqrt(1.05 * 1.05 + 2 * 10 * 0.09), 1e-12);
  EXPECT_NEAR(turn.speed_out, turn.speed_in, 1e-12);
  EXPECT_NEAR(turn.seconds, kPi * 0.09 / 1.05 + 2 * (turn.speed_in - 1.05) / 10, 1e-12);
}

TEST(FreeSpeedRun, IsNoSlowerThanSteadyOnesAndNoFasterThanItsBound) {
  for (std::uint64_t seed = 1; seed <= mazes(); ++seed) {
    const GridMaze maze = random_maze(3 + static_cast<int>(seed % 6), 3 + static_cast<int>(seed % 5), seed,
                                      static_cast<double>(seed % 4) * 0.15);
    for (const SpeedModel& model : {SpeedModel{}, lame(), nimble()}) {
      const auto steady = speed_run(maze, model);
      const auto free = free_speed_run(maze, model);
      ASSERT_EQ(steady.has_value(), free.has_value());
      if (!steady) continue;
      const SpeedRun fast = at_full_speed(*steady, model);
      EXPECT_LE(fast.seconds, steady->seconds * (1 + 1e-12)) << seed;
      EXPECT_LE(free->run.seconds, fast.seconds) << seed;
      EXPECT_LE(free->bound, free->run.seconds) << seed;
      EXPECT_GE(free->bound, kNear * free->run.seconds) << seed;
      expect_sound(free->run, maze, model);
    }
  }
}

TEST(FreeSpeedRun, IsBeatenByNoLineOfASmallMaze) {
  for (std::uint64_t seed = 1; seed <= std::min<std::uint64_t>(mazes(), 2000) / 4; ++seed) {
    GridMaze maze = generate_backtracker(3, 3 + static_cast<int>(seed % 2), seed);
    open_walls(maze, static_cast<double>(seed % 3) * 0.15, seed);
    maze.goal = {{2, 2}};
    for (const SpeedModel& model : {SpeedModel{}, lame()}) {
      const auto free = free_speed_run(maze, model);
      ASSERT_TRUE(free);
      const double least = EveryLine(maze, model).least_seconds(free->run.seconds + kSlices);
      EXPECT_GE(least, free->bound - kSlices) << seed;
      EXPECT_LE(least, free->run.seconds + kSlices / 2) << seed;
    }
  }
}

TEST(FreeSpeedRun, BoundsTheContestMazesTightly) {
  for (const GridMaze& maze : contest_mazes(3, 1)) {
    const auto free = free_speed_run(maze);
    ASSERT_TRUE(free);
    expect_sound(free->run, maze, {});
    EXPECT_GE(free->bound, 0.995 * free->run.seconds);
  }
}

TEST(FreeSpeedRun, IsAbsentWithoutAWay) {
  EXPECT_FALSE(free_speed_run(drawn("o---o---o\n|   | G |\no   o---o\n| S |   |\no---o---o\n")).has_value());
}

}  // namespace
}  // namespace taut::micromouse
