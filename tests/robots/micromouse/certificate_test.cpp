#include <taut/robots/micromouse/certificate.h>

#include <gtest/gtest.h>

#include <taut/robots/micromouse/explorers.h>
#include <taut/robots/micromouse/oracle.h>

#include "robots/micromouse/support.h"

namespace taut::micromouse {
namespace {

struct Proven {
  GridMaze maze;
  Record record;
  Certificate certificate;
};

Proven proven(std::uint64_t seed) {
  const GridMaze maze = generated(10, seed);
  const auto robot = make_explorer(Explorer::prove, task_of(maze));
  const Record record = run_trial(maze, *robot);
  return {maze, record, *certificate(record)};
}

TEST(Certificate, FailsWithoutAnyOneOfItsWalls) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Proven p = proven(seed);
    ASSERT_TRUE(verify_certificate(p.certificate, p.maze, p.record));
    for (std::size_t i = 0; i < p.certificate.walls.size(); ++i) {
      Certificate tampered = p.certificate;
      tampered.walls.erase(tampered.walls.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_FALSE(verify_certificate(tampered, p.maze));
    }
  }
}

TEST(Certificate, FailsWhenAWordOfItIsChanged) {
  std::uint64_t seed = 1;
  while (proven(seed).certificate.walls.empty()) ++seed;
  const Proven p = proven(seed);
  const auto fails = [&](auto change) {
    Certificate tampered = p.certificate;
    change(tampered);
    return !verify_certificate(tampered, p.maze, p.record);
  };
  EXPECT_TRUE(fails([](Certificate& c) { --c.steps; }));
  EXPECT_TRUE(fails([](Certificate& c) { ++c.steps; }));
  EXPECT_TRUE(fails([](Certificate& c) { c.route.pop_back(); }));
  EXPECT_TRUE(fails([](Certificate& c) { c.route[1] = c.route[0]; }));
  EXPECT_TRUE(fails([](Certificate& c) { c.openings.pop_back(); }));
  EXPECT_TRUE(fails([](Certificate& c) { c.openings[0].closed = true; }));
  EXPECT_TRUE(fails([](Certificate& c) { c.walls[0].step = static_cast<int>(1e6); }));
  EXPECT_TRUE(fails([](Certificate& c) { c.walls.push_back(c.openings[0]); }));
  EXPECT_TRUE(fails([](Certificate& c) { c.task.goal = {{0, 1}}; }));
  EXPECT_TRUE(fails([](Certificate& c) { c.walls[0].wall = {{-1, 50}, Side::north}; }));
}

TEST(Certificate, IsOfThisMazeOnly) {
  const Proven a = proven(3), b = proven(4);
  EXPECT_FALSE(verify_certificate(a.certificate, b.maze));
}

TEST(Certificate, IsAbsentWhenRunOneHasNotProvenIt) {
  const GridMaze maze = generated(12, 8);
  const auto robot = make_explorer(Explorer::flood_fill, task_of(maze));
  EXPECT_FALSE(certificate(run_trial(maze, *robot)));
}

TEST(ProofBound, IsAtMostWhatAnyProvingRobotNeeds) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const GridMaze maze = generated(10, seed);
    const auto bound = proof_bound(maze, {9});
    ASSERT_TRUE(bound);
    for (const Explorer e : {Explorer::prove, Explorer::plain_prove, Explorer::breadth_first}) {
      const auto robot = make_explorer(e, task_of(maze));
      const Record record = run_trial(maze, *robot);
      if (!certificate(record)) continue;
      EXPECT_LE(bound->run1, record.run1) << name(e) << " " << seed;
    }
  }
}

/// All walks of a robot that knows the maze, by brute force: the first length at which one holds a proof.
int cheapest_proof(const GridMaze& maze) {
  std::vector<std::vector<Action>> walks{{}};
  for (;;) {
    std::vector<std::vector<Action>> longer;
    for (const auto& walk : walks) {
      Trial trial(maze);
      for (const Action& a : walk) trial.act(a);
      if (trial.record().goal_at) {
        trial.act(kReset);
        if (certificate(trial.record())) return trial.record().run1;
      }
      for (const int rotation : {-90, 0, 90})
        for (int movement = -2; movement <= 2; ++movement) {
          longer.push_back(walk);
          longer.back().push_back({rotation, movement});
        }
    }
    walks = std::move(longer);
  }
}

TEST(ProofBound, IsWhatBruteForceFindsInTinyMazes) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    GridMaze maze = generate_backtracker(3, 3, seed);
    open_walls(maze, 0.5, seed);
    maze.goal = centre_room(3, 3);
    const auto bound = proof_bound(maze);
    ASSERT_TRUE(bound);
    EXPECT_TRUE(bound->exact);
    EXPECT_EQ(bound->run1, cheapest_proof(maze)) << seed;
  }
}

TEST(Benchmarks, AreTheProposals) {
  const GridMaze maze(12, 12, false);
  EXPECT_DOUBLE_EQ(*benchmark_every_cell(maze), *optimum(passages_of(maze), task_of(maze)) + 144.0 / 30);
  EXPECT_GT(*benchmark_random_walkers(maze), *absolute_floor(maze));
  EXPECT_FALSE(absolute_floor(GridMaze(6, 6, true)));
}

TEST(Benchmarks, HaveTheOptimumByBothRunsForAFloor) {
  EXPECT_DOUBLE_EQ(*absolute_floor(maze_in(test::data_dir() / "mouse_16.maz")), 13 + 14 / 30.0);
  if (const auto maze = first_of_the_course()) {
    EXPECT_DOUBLE_EQ(*absolute_floor(*maze), 17.6);
  }
}

}  // namespace
}  // namespace taut::micromouse
