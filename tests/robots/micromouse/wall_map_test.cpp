#include <taut/robots/micromouse/wall_map.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/robots/micromouse/trial.h>

#include "robots/micromouse/support.h"

namespace taut::micromouse {
namespace {

TEST(WallMap, KnowsTheBorderBeforehand) {
  const WallMap map(Task{4, 4, {0, 0}, {{1, 1}}});
  EXPECT_EQ(map.state({0, 0}, Side::south), WallState::closed);
  EXPECT_EQ(map.state({3, 3}, Side::east), WallState::closed);
  EXPECT_EQ(map.state({0, 0}, Side::north), WallState::unknown);
  EXPECT_EQ(map.unknown(), 24U);
}

TEST(WallMap, AReadingOpensTheCellsBeforeTheWallAndClosesTheWall) {
  WallMap map(Task{4, 4, {0, 0}, {{1, 1}}});
  const auto news = map.see({{0, 0}, Side::north}, {0, 2, 1});
  EXPECT_EQ(map.state({0, 1}, Side::north), WallState::open);
  EXPECT_EQ(map.state({0, 3}, Side::south), WallState::closed);
  EXPECT_EQ(map.state({1, 0}, Side::east), WallState::closed);
  EXPECT_EQ(news.size(), 5U);
  EXPECT_TRUE(map.see({{0, 0}, Side::north}, {0, 2, 1}).empty());
}

TEST(WallMap, ABackwardMoveCutShortClosesTheWallBehind) {
  WallMap map(Task{4, 4, {0, 0}, {{1, 1}}});
  map.see({{0, 2}, Side::north}, {0, 1, 0});
  const auto news = map.move({{0, 2}, Side::north}, {0, -3}, {{0, 1}, Side::north});
  EXPECT_EQ(news, (std::vector<WallSeen>{{{{0, 1}, Side::north}, false}, {{{0, 0}, Side::north}, true}}));
}

TEST(WallMap, AMoveOfThreeSaysNothingOfTheWallBeyond) {
  WallMap map(Task{6, 6, {0, 0}, {{1, 1}}});
  map.move({{0, 4}, Side::north}, {0, -9}, {{0, 1}, Side::north});
  EXPECT_EQ(map.state({0, 1}, Side::south), WallState::unknown);
}

RC_GTEST_PROP(WallMap, AgreesWithTheMazeWhateverTheRobotDoes, ()) {
  const GridMaze maze = generated(8, *rc::gen::inRange<std::uint64_t>(0, 1000));
  Trial trial(maze, 50);
  while (!trial.over()) trial.act({*rc::gen::element(-90, 0, 90), *rc::gen::inRange(-3, 4)});
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (const Side side : kSides) {
        const WallState state = trial.known().state({x, y}, side);
        RC_ASSERT(state == WallState::unknown || (state == WallState::closed) == maze.wall({x, y}, side));
      }
}

}  // namespace
}  // namespace taut::micromouse
