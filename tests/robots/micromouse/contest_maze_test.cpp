#include <taut/robots/micromouse/contest_maze.h>

#include <gtest/gtest.h>

#include <bit>

#include "robots/micromouse/support.h"

namespace taut::micromouse {
namespace {

/// How many of the interior walls stand, as a share.
double wall_share(const Passages& passages) {
  const auto w = static_cast<std::size_t>(passages.width), h = static_cast<std::size_t>(passages.height);
  const std::size_t interior = (w - 1) * h + w * (h - 1);
  std::size_t open = 0;
  for (const std::uint64_t k : passages.north) open += static_cast<std::size_t>(std::popcount(k));
  for (const std::uint64_t k : passages.east) open += static_cast<std::size_t>(std::popcount(k));
  return interior == 0 ? 0 : static_cast<double>(interior - open) / static_cast<double>(interior);
}

TEST(ContestMaze, HasTheWallsTheRouteAndTheSingleEntranceAskedFor) {
  int made = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto maze = contest_maze({12, 17, true}, seed);
    if (!maze) continue;
    ++made;
    const Task task = task_of(*maze);
    const Passages open = passages_of(*maze);
    EXPECT_NEAR(wall_share(open), kContestWalls, 0.004) << seed;
    EXPECT_GE(*optimum(open, task), 17) << seed;
    int entrances = 0;
    for (const Cell c : task.goal)
      for (const Side side : kSides) entrances += open.open(c, side) && !task.in_goal(ahead(c, side));
    EXPECT_EQ(entrances, 1) << seed;
    const StepField reached(open, {task.start});
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x) EXPECT_TRUE(reached.reached({x, y})) << seed;
  }
  EXPECT_GE(made, 3);
}

TEST(ContestMaze, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const auto mazes = contest_mazes(4, 1);
  EXPECT_EQ(mazes, contest_mazes(4, 1));
  EXPECT_NE(mazes[0], contest_mazes(1, 2)[0]);
}

TEST(ContestMaze, IsAbsentWhenNoRouteCanBeThatLong) { EXPECT_FALSE(contest_maze({12, 100, true}, 1)); }

}  // namespace
}  // namespace taut::micromouse
