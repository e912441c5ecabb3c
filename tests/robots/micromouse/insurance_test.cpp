#include <taut/robots/micromouse/insurance.h>

#include <gtest/gtest.h>

#include <cmath>

#include <taut/robots/micromouse/contest.h>
#include <taut/robots/micromouse/contest_maze.h>
#include <taut/robots/micromouse/steps.h>

#include "robots/micromouse/support.h"

namespace taut::micromouse {
namespace {

Record run_of(Explorer explorer, const GridMaze& maze, std::uint64_t seed) {
  const auto robot = make_explorer(explorer, task_of(maze), seed);
  return run_trial(maze, *robot);
}

GridMaze any_contest_maze(std::uint64_t seed) {
  for (;; ++seed)
    if (auto maze = contest_maze({12, 12, true}, seed)) return *maze;
}

TEST(Insurance, CountsTheStepsAfterTheGoalAndWhatRun2Saves) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const GridMaze maze = any_contest_maze(10 * seed);
    const Record flood = run_of(Explorer::flood_fill, maze, 1), score = run_of(Explorer::score, maze, seed);
    const auto none = insurance_of(flood), some = insurance_of(score, seed);
    ASSERT_TRUE(none && some);
    EXPECT_EQ(none->paid, 0);
    EXPECT_GE(none->expected, 0);
    EXPECT_EQ(some->paid, score.run1 - 1 - *score.goal_at);
    // By the walls seen up to the goal, and by the true ones.
    EXPECT_GE(some->known, *optimum(passages_of(maze), score.task));
    EXPECT_EQ(some->back, some->known - score.run2);
    EXPECT_DOUBLE_EQ(some->balance(), some->back - some->paid / 30.0);
  }
}

TEST(Insurance, ExpectsNothingWhereAllIsKnown) {
  const GridMaze maze = any_contest_maze(1);
  const Task task = task_of(maze);
  WallMap map(task);
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x)
      for (const Side side : kSides) map.learn({x, y}, side, maze.wall({x, y}, side));
  EXPECT_EQ(expected_gain(task, map), 0);
  EXPECT_FALSE(expected_gain(task, WallMap(task)));
}

TEST(Insurance, IsForFinishedTrialsAlone) {
  const GridMaze maze = any_contest_maze(1);
  const auto robot = make_explorer(Explorer::score, task_of(maze, 5), 1);
  EXPECT_FALSE(insurance_of(run_trial(maze, *robot, 5)));
}

TEST(Seeds, ChangeWhatScoreDoesButNotWhatFloodDoes) {
  bool differs = false;
  const GridMaze maze = any_contest_maze(30);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Score a = score_of(Explorer::score, maze, kMaxSteps, 1), b = score_of(Explorer::score, maze, kMaxSteps, seed);
    differs |= a.thirtieths != b.thirtieths;
    EXPECT_EQ(score_of(Explorer::flood_fill, maze, kMaxSteps, 1).thirtieths,
              score_of(Explorer::flood_fill, maze, kMaxSteps, seed).thirtieths);
  }
  EXPECT_TRUE(differs);
}

TEST(Seeds, AreSummarisedByStandardDeviations) {
  Contest contest;
  contest.mazes = {"a", "b"};
  const auto score = [](int thirtieths) { return Score{0, 0, thirtieths}; };
  contest.scores = {{score(30), score(60)}};
  EXPECT_FALSE(contest.spread(0));
  contest.more = {{{score(90), score(60)}}};
  const auto spread = contest.spread(0);
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->means, (std::vector<double>{1.5, 2.5}));
  EXPECT_DOUBLE_EQ(spread->of_means, std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(spread->of_a_maze, std::sqrt((2.0 + 0) / 2));
  contest.more[0][0][0] = {};
  EXPECT_EQ(contest.spread(0)->means, (std::vector<double>{2, 2}));  // of the maze that both finished
}

}  // namespace
}  // namespace taut::micromouse
