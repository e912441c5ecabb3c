#include <taut/geometry/corridor_width.h>

#include <gtest/gtest.h>

#include <memory>

#include <taut/geometry/maze_generator.h>

#include "support/small_world.h"

namespace taut {
namespace {

TEST(CorridorWidth, IsThatOfTheCellsOfAMaze) {
  const auto maze = std::make_shared<const GridMaze>(generate_biased_maze(41, 41, 1));
  EXPECT_NEAR(corridor_width(FreeSpace{world_of(maze)}), 1, 0.2);
  EXPECT_NEAR(corridor_width(FreeSpace{world_of(maze, 1e6)}), 1e6, 2e5);
}

TEST(CorridorWidth, IsTwiceTheAreaByTheOutline) {
  EXPECT_DOUBLE_EQ(corridor_width(test::SmallWorld{.area = test::box_ring(0, 0, 24, 1)}.space()), 0.96);
}

TEST(CorridorWidth, IsAtMostAnEighthOfTheLongerSide) {
  EXPECT_EQ(corridor_width(test::SmallWorld{.area = test::box_ring(0, 0, 8, 4)}.space()), 1);
}

}  // namespace
}  // namespace taut
