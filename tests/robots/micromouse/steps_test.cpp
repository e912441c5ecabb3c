#include <taut/robots/micromouse/steps.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <deque>
#include <map>

#include "robots/micromouse/support.h"

namespace taut::micromouse {
namespace {

/// Cell by cell with a queue, straight from the maze.
std::map<Cell, int> by_queue(const GridMaze& maze, Cell from) {
  std::map<Cell, int> steps{{from, 0}};
  std::deque<Cell> queue{from};
  for (; !queue.empty(); queue.pop_front())
    for (const Side side : kSides) {
      Cell c = queue.front();
      for (int i = 0; i < 3 && !maze.wall(c, side); ++i) {
        c = GridMaze::neighbour(c, side);
        if (steps.emplace(c, steps.at(queue.front()) + 1).second) queue.push_back(c);
      }
    }
  return steps;
}

RC_GTEST_PROP(StepField, AgreesWithAQueue, ()) {
  // Widths on either side of a machine word.
  const int w = *rc::gen::element(2, 5, 16, 63, 64, 65), h = *rc::gen::element(2, 7, 16, 32);
  GridMaze maze = generate_backtracker(w, h, *rc::gen::inRange<std::uint64_t>(0, 1000));
  open_walls(maze, 0.2, 7);
  const auto expected = by_queue(maze, {0, 0});
  const StepField field(passages_of(maze), {{0, 0}});
  for (int x = 0; x < w; ++x)
    for (int y = 0; y < h; ++y) RC_ASSERT(field({x, y}) == expected.at({x, y}));
}

TEST(Optimum, CountsStepsNotCells) {
  GridMaze maze(8, 8, false);
  EXPECT_EQ(optimum(passages_of(maze), task_of(maze)), 2);  // three up, three right
}

TEST(Optimum, IsAbsentWhenTheRoomIsClosed) {
  EXPECT_FALSE(optimum(passages(8, 8, false), task_of(GridMaze(8, 8, false))));
}

TEST(Optimum, IsAtLeastOneStep) {
  const GridMaze maze(2, 2, false);
  EXPECT_EQ(optimum(passages_of(maze), task_of(maze)), 1);
}

TEST(Optimum, IsThatOfAQueueInMazesOfFiles) {
  for (const char* file : {"mouse_12.cells", "mouse_16.maz", "mouse_16.num", "mouse_32.maze"}) {
    const GridMaze maze = maze_in(test::data_dir() / file);
    const auto steps = by_queue(maze, {0, 0});
    int least = 1'000'000;
    for (const Cell goal : maze.goal) least = std::min(least, steps.at(goal));
    EXPECT_EQ(optimum(passages_of(maze), task_of(maze)), least) << file;
  }
  if (const auto maze = first_of_the_course()) {
    EXPECT_EQ(optimum(passages_of(*maze), task_of(*maze)), 17);
  }
}

TEST(ActionTowards, GoesBackwardsOnlyToWhatLiesBehind) {
  const MousePose pose{{4, 4}, Side::east};
  EXPECT_EQ(action_towards(pose, {6, 4}), (Action{0, 2}));
  EXPECT_EQ(action_towards(pose, {3, 4}), (Action{0, -1}));
  EXPECT_EQ(action_towards(pose, {4, 7}), (Action{-90, 3}));
  EXPECT_EQ(action_towards(pose, {4, 2}), (Action{90, 2}));
}

}  // namespace
}  // namespace taut::micromouse
