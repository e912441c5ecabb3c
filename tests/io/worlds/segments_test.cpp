#include <gtest/gtest.h>

#include <cmath>

#include <taut/io/worlds/read_world.h>

namespace taut {
namespace {

TEST(Segments, ReadsWallsCommentsAndAllSeparators) {
  const World world = read_world("# head\n0.5 .5 7.5 0.5\r\n\t1,2,3,4 # tail\n\n-1e0 ,\t+2  3., 4e-1 0.25   \n0 0 0 1");
  ASSERT_EQ(world.walls().size(), 4U);
  EXPECT_EQ(world.walls()[0].a, (Point{0.5, 0.5}));
  EXPECT_EQ(world.walls()[0].line, 2);
  EXPECT_EQ(world.walls()[1].b, (Point{3, 4}));
  EXPECT_EQ(world.walls()[2].a, (Point{-1, 2}));
  EXPECT_EQ(world.walls()[2].b, (Point{3, 0.4}));
  EXPECT_EQ(world.walls()[2].thickness, 0.25);
  EXPECT_EQ(world.walls()[3].line, 6);
}

TEST(Segments, ReadsTheTablesThatNameTheirColumns) {
  for (const char* header : {"x1,y1,x2,y2", "# walls\nX1 Y1 X2 Y2", "x1, y1, x2, y2, thickness"}) {
    const World world = read_world(std::string(header) + "\n0,0,4,0\n4,0,4,3,0.5\n");
    ASSERT_EQ(world.walls().size(), 2U) << header;
    EXPECT_EQ(world.walls()[1].thickness, 0.5);
  }
  EXPECT_THROW(read_world("x1,x2,y1,y2\n0,4,0,0\n"), InputError);
  EXPECT_THROW(read_world("0 0 4 0\nx1,y1,x2,y2\n"), InputError);
}

TEST(Segments, ReadsStartGoalAndABoundaryBox) {
  const World world = read_world("start 1 1\ngoal 3 -0\nboundary 0 -1 4 2\n1 0 1 1\n");
  EXPECT_EQ(world.start(), (Point{1, 1}));
  EXPECT_EQ(world.goal().point, (Point{3, 0}));
  EXPECT_FALSE(std::signbit(world.goal().point->y));
  EXPECT_EQ(world.box(), (Box{{0, -1}, {4, 2}}));
  EXPECT_EQ(world.boundary(), Boundary::limit);
  EXPECT_EQ(world.openings().size(), 4U);
}

TEST(Segments, ReadsABoundaryRingOfEitherOrientation) {
  const World world = read_world("boundary 0 0 0 4 4 0\n");
  EXPECT_EQ(world.areas()[0].polygon.outer, (Ring{{0, 0}, {4, 0}, {0, 4}}));
  EXPECT_EQ(world.areas()[0].line, 1);
}

TEST(Segments, ReadsARoomAsGoal) {
  const World world = read_world("0 0 9 9\ngoal 0 0 1 1 1 0 2 1\n");
  ASSERT_EQ(world.goal().room.size(), 2U);
  EXPECT_EQ(world.goal().room[1], (Box{{1, 0}, {2, 1}}));
  EXPECT_FALSE(world.goal().point);
}

TEST(Segments, GoFromOpeningToOpening) {
  // The border of 1 x 2 cells, left side of the first and right side of the last missing.
  const World world = read_world("0.5 0.5 2.5 0.5\n0.5 1.5 2.5 1.5\n");
  EXPECT_EQ(world.start(), (Point{0.5, 1}));
  EXPECT_EQ(world.goal().point, (Point{2.5, 1}));
}

}  // namespace
}  // namespace taut
