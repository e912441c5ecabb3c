#include <taut/robots/micromouse/explorers.h>

#include <gtest/gtest.h>

#include <taut/robots/micromouse/certificate.h>

#include "robots/micromouse/support.h"

namespace taut::micromouse {
namespace {

Record played(const GridMaze& maze, Explorer explorer) {
  const auto robot = make_explorer(explorer, task_of(maze));
  return run_trial(maze, *robot);
}

TEST(Explorers, HaveNamesThatReadBack) {
  for (const Explorer e : all_explorers()) EXPECT_EQ(explorer_named(name(e)), e);
  EXPECT_FALSE(explorer_named("hoover"));
}

TEST(Explorers, KeepTheRulesAndNeverOffend) {
  for (const Explorer e : all_explorers())
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const GridMaze maze = generated(8, seed);
      const Record record = played(maze, e);
      EXPECT_EQ(verify_record(record, maze).reason, "") << name(e) << " " << seed;
      for (const Step& step : record.steps) EXPECT_EQ(step.offence, Offence::none) << name(e) << " " << seed;
    }
}

TEST(Explorers, DoTheSameTwice) {
  const GridMaze maze = generated(12, 3);
  for (const Explorer e : all_explorers()) {
    const Record a = played(maze, e), b = played(maze, e);
    ASSERT_EQ(a.steps.size(), b.steps.size()) << name(e);
    for (std::size_t i = 0; i < a.steps.size(); ++i) ASSERT_EQ(a.steps[i].action, b.steps[i].action) << name(e);
  }
}

TEST(Explorers, CopeWithSmallOddAndRectangularMazes) {
  for (const auto& [w, h] : {std::pair{1, 2}, {2, 2}, {3, 3}, {5, 4}, {4, 9}, {7, 1}})
    for (const Explorer e : {Explorer::breadth_first, Explorer::flood_fill, Explorer::a_star, Explorer::plain_prove,
                             Explorer::prove, Explorer::score}) {
      GridMaze maze = generate_backtracker(w, h, 5);
      maze.goal = centre_room(w, h);
      EXPECT_EQ(played(maze, e).status, TrialStatus::finished) << w << " x " << h << " " << name(e);
    }
}

TEST(Explorers, ProvingOnesFindTheOptimumOfGeneratedMazesAndCertifyIt) {
  for (std::uint64_t seed = 500; seed < 530; ++seed) {
    const GridMaze maze = generated(12 + 2 * static_cast<int>(seed % 3), seed);
    const int best = *optimum(passages_of(maze), task_of(maze));
    for (const Explorer e : {Explorer::plain_prove, Explorer::prove}) {
      const Record record = played(maze, e);
      EXPECT_EQ(record.run2, best) << seed;
      const auto proof = certificate(record);
      ASSERT_TRUE(proof) << seed;
      EXPECT_EQ(proof->steps, best);
      EXPECT_EQ(verify_certificate(*proof, maze, record).reason, "") << seed;
    }
  }
}

double mean_score(const std::vector<GridMaze>& mazes, Explorer explorer) {
  double sum = 0;
  for (const GridMaze& maze : mazes) sum += played(maze, explorer).score().value_or(1000);
  return sum / static_cast<double>(mazes.size());
}

TEST(Explorers, OursBeatThePlainOnesOnTheMeanOfGeneratedMazes) {
  std::vector<GridMaze> mazes;
  for (std::uint64_t seed = 600; seed < 630; ++seed)
    mazes.push_back(generated(12 + 2 * static_cast<int>(seed % 3), seed));
  EXPECT_LT(mean_score(mazes, Explorer::prove), mean_score(mazes, Explorer::plain_prove));
  EXPECT_LT(mean_score(mazes, Explorer::score), mean_score(mazes, Explorer::flood_fill) - 1);
}

TEST(Explorers, OursBeatThePlainOnesOnTheMeanOfMazesWithLongRoutes) {
  const auto mazes = contest_mazes(18, 700);
  const double prove = mean_score(mazes, Explorer::prove), score = mean_score(mazes, Explorer::score);
  EXPECT_LT(prove, mean_score(mazes, Explorer::plain_prove));
  EXPECT_LT(score, prove - 0.2);
  EXPECT_LT(score, mean_score(mazes, Explorer::flood_fill) - 1);
}

TEST(Explorers, ReachTheGoalInLargeMazesBeforeStepsRunOut) {
  GridMaze maze = generate_backtracker(32, 32, 4);
  open_walls(maze, 0.1, 4);
  open_centre_room(maze);
  for (const Explorer e : {Explorer::prove, Explorer::score})
    EXPECT_EQ(played(maze, e).status, TrialStatus::finished) << name(e);
}

TEST(Explorers, ProveFindsTheOptimumOfMazesWithLongRoutes) {
  std::vector<GridMaze> mazes = contest_mazes(6, 900);
  for (const char* file : {"mouse_12.cells", "mouse_16.maz", "mouse_16.num"})
    mazes.push_back(maze_in(test::data_dir() / file));
  for (const GridMaze& maze : competition(6)) mazes.push_back(maze);
  for (const GridMaze& maze : mazes) {
    const Record record = played(maze, Explorer::prove);
    EXPECT_EQ(record.run2, optimum(passages_of(maze), task_of(maze)));
    const auto proof = certificate(record);
    ASSERT_TRUE(proof);
    EXPECT_EQ(verify_certificate(*proof, maze, record).reason, "");
  }
}

void expect_scores_below(const GridMaze& maze, double prove, double score) {
  EXPECT_LT(*played(maze, Explorer::prove).score(), prove);
  EXPECT_LT(*played(maze, Explorer::score).score(), score);
}

// On our maze a robot that sees every cell in run 1 has 21.53.
TEST(Explorers, MeetTheBarsOnSingleMazes) {
  expect_scores_below(maze_in(test::data_dir() / "mouse_16.maz"), 21.5, 15);
  if (const auto maze = first_of_the_course()) expect_scores_below(*maze, 20.9, 19.03);
}

}  // namespace
}  // namespace taut::micromouse
