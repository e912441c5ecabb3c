#include <taut/robots/micromouse/detail/belief.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <taut/robots/micromouse/detail/boards.h>
#include <taut/robots/micromouse/detail/wall_field.h>

#include "robots/micromouse/support.h"

namespace taut::micromouse::detail {
namespace {

Task task_4x4() { return {4, 4, {0, 0}, {{1, 1}, {1, 2}, {2, 1}, {2, 2}}}; }

/// All known of a maze but some walls.
WallMap all_but(const GridMaze& maze, const std::vector<CellSide>& hidden) {
  WallMap map(task_of(maze));
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x)
      for (const Side side : {Side::north, Side::east})
        if (std::find(hidden.begin(), hidden.end(), CellSide{{x, y}, side}) == hidden.end())
          map.learn({x, y}, side, maze.wall({x, y}, side));
  return map;
}

/// The logarithm of the law's weight of a maze, from its definition: posts, cells, walls one by one.
double log_weight(const GridMaze& maze, const WallField& field) {
  double sum = 0;
  const auto arm = [&](int x, int y, Side side) {  // of the post at the lower left of cell (x, y)
    switch (side) {
      case Side::north: return maze.wall({x, y}, Side::west);
      case Side::east: return maze.wall({x, y}, Side::south);
      case Side::south: return maze.wall({x, y - 1}, Side::west);
      case Side::west: return maze.wall({x - 1, y}, Side::south);
    }
    return false;
  };
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x) {
      unsigned sides = 0, arms = 0;
      for (const Side side : kSides) {
        sides |= unsigned{maze.wall({x, y}, side)} << static_cast<unsigned>(side);
        if (x > 0 && y > 0) arms |= unsigned{arm(x, y, side)} << static_cast<unsigned>(side);
      }
      sum += field.cell_of(sides);
      if (x > 0 && y > 0) sum += field.post_of(arms);
      for (const Side side : {Side::north, Side::east}) {
        if (!maze.contains(ahead({x, y}, side)) || !maze.wall({x, y}, side)) continue;
        const bool one_end = side == Side::north ? x == 0 : y == 0,
                   other = side == Side::north ? x + 1 == maze.width() : y + 1 == maze.height();
        sum += field.wall + field.border_arm * (int{one_end} + int{other});
      }
    }
  return sum;
}

TEST(Belief, DrawsWallsAsOftenAsTheLawSays) {
  // A comb that keeps all cells connected, and four unknown walls: 16 mazes, weighed one by one.
  GridMaze maze(4, 4, false);
  for (int y = 1; y < 4; ++y) maze.set_wall({0, y}, Side::east, true);
  const std::vector<CellSide> hidden{
      {{1, 1}, Side::east}, {{1, 2}, Side::east}, {{2, 3}, Side::east}, {{2, 1}, Side::north}};
  const WallMap map = all_but(maze, hidden);
  double total = 0;
  std::array<double, 4> open{};
  for (unsigned k = 0; k < 16; ++k) {
    for (unsigned i = 0; i < 4; ++i) maze.set_wall(hidden[i].cell, hidden[i].side, (k >> i & 1U) != 0);
    const double weight = std::exp(log_weight(maze, kField));
    total += weight;
    for (unsigned i = 0; i < 4; ++i) open[i] += (k >> i & 1U) == 0 ? weight : 0;
  }
  Belief belief(task_of(maze), 50, 7);
  std::array<double, 4> drawn{};
  constexpr int kUpdates = 400;
  for (int k = 0; k < kUpdates; ++k) {
    belief.update(map);
    const WallBoard share = belief.open_share();
    for (std::size_t i = 0; i < 4; ++i)
      drawn[i] += (hidden[i].side == Side::north ? share.north : share.east)[index_of(4, hidden[i].cell)];
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(drawn[i] / kUpdates, open[i] / total, 0.02) << i;
}

TEST(Belief, SamplesAreConnectedAndAgreeWithWhatIsKnown) {
  const GridMaze maze = generated(12, 5);
  const Task task = task_of(maze);
  WallMap map(task);
  Belief belief(task, 8, 3);
  for (const Cell c : {Cell{0, 0}, Cell{5, 5}, Cell{9, 2}, Cell{3, 11}}) {
    for (const Side side : kSides) map.learn(c, side, maze.wall(c, side));
    belief.update(map);
    for (int k = 0; k < belief.samples(); ++k) {
      const StepField reached(belief.world(k), {task.start});
      for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
          EXPECT_TRUE(reached.reached({x, y}));
          for (const Side side : kSides) {
            const WallState state = map.state({x, y}, side);
            if (state != WallState::unknown) {
              EXPECT_EQ(belief.world(k).open({x, y}, side), state == WallState::open);
            }
          }
        }
    }
  }
}

TEST(Belief, ThinnedSamplesLoseWallsOnlyAndAllUnknownOnesWhenTheShareIsOne) {
  const Task task = task_4x4();
  WallMap map(task);
  map.learn({0, 0}, Side::east, true);
  Belief belief(task, 4, 3);
  belief.update(map);
  Passages thin;
  belief.thinned(2, 0.5, thin);
  for (std::size_t k = 0; k < thin.words(); ++k) EXPECT_EQ(belief.world(2).north[k] & ~thin.north[k], 0U);
  belief.thinned(2, 1, thin);
  EXPECT_EQ(thin.north, map.possible().north);
  EXPECT_EQ(thin.east, map.possible().east);
}

TEST(Belief, AnOutlookCountsNearWallsFullyAndThoseBehindByTheirShare) {
  const Task task = task_4x4();
  WallMap map(task);
  map.learn({0, 0}, Side::north, false);
  WallBoard weights{std::vector<float>(16), std::vector<float>(16)}, open = weights;
  weights.north[4] = 2, weights.north[8] = 8, open.north[4] = 0.25F;
  const Outlook outlook(map, weights, open);
  EXPECT_FLOAT_EQ(outlook.ray(0, Side::north), 2 + 0.25F * 8);
  EXPECT_FLOAT_EQ(outlook.at(0, Side::east), 4);   // to the left
  EXPECT_FLOAT_EQ(outlook.at(0, Side::south), 0);  // behind
}

}  // namespace
}  // namespace taut::micromouse::detail
