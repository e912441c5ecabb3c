// Cells of poses: what they rule out, no car can do.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <taut/robots/roadblocks/detail/pose_cells.h>
#include <taut/robots/roadblocks/lattice_planner.h>
#include <taut/robots/roadblocks/roadblock_map_generator.h>

namespace taut::roadblocks {
namespace {

double between(std::mt19937_64& random, double least, double most) {
  return least + (most - least) * static_cast<double>(random() >> 11) / 9007199254740992.0;
}

Course walled_room(int width, int height) {
  Course course{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height)), {}, {}, {}};
  for (int y = 1; y <= height; ++y)
    for (int x = 1; x <= width; ++x)
      if (x == 1 || y == 1 || x == width || y == height) course.walls[course.index({x, y})] = 1;
  return course;
}

TEST(PoseCells, ReachEveryPoseThatDrivesAtRandomToOneThatTheyReach) {
  std::mt19937_64 random(7);
  for (const WallReading reading : {WallReading::points, WallReading::squares}) {
    const RoadblockMap map = generate_roadblock_map({24, 24, 2, 1, 5});
    const detail::Obstacles obstacles(map.course, 1, reading);
    const detail::PoseCells cells(obstacles, map.course.goal);
    int steps = 0;
    for (int drive = 0; drive < 4000; ++drive) {
      Pose pose{between(random, 2, 23), between(random, 2, 23), between(random, -4, 4)};
      if (!obstacles.is_free(pose, 1e-9)) continue;
      std::vector<Pose> way{pose};
      for (int i = 0; i < 30; ++i) {
        const double control = random() % 3 == 0 ? kReverse : between(random, -1, 1);
        const Pose to = stepped(pose, control);
        if (!obstacles.is_clear(pose, control, to, 1e-9)) continue;
        way.push_back(pose = to);
      }
      for (std::size_t i = way.size() - 1; i-- > 0; ++steps)
        if (cells.reaches(way[i + 1])) {
          ASSERT_TRUE(cells.reaches(way[i])) << way[i].x << " " << way[i].y << " " << way[i].heading;
        }
    }
    EXPECT_GT(steps, 10000);
  }
}

TEST(PoseCells, ProveThatAGapOfTwoIsNoWayAndOneOfThreeMayBe) {
  for (const WallReading reading : {WallReading::points, WallReading::squares})
    for (const int gap : {2, 3}) {
      Course course = walled_room(30, 15);
      const int open = reading == WallReading::points ? gap - 1 : gap;  // cells
      for (int y = 2; y < 15; ++y)
        if (y < 6 || y >= 6 + open) course.walls[course.index({15, y})] = 1;
      course.goal = {25, 7};
      const detail::PoseCells cells(detail::Obstacles(course, 0, reading), course.goal);
      EXPECT_EQ(cells.reaches({6, 7, 0}), gap == 3);
      EXPECT_TRUE(cells.reaches({20, 7, 1}));
    }
}

/// Two rooms, one above the other, and between them a lane that runs down to the left and then to the right, each row
/// one cell on.
Course bent_lane(int open) {
  Course course = walled_room(30, 27);
  for (int y = 11; y <= 17; ++y)
    for (int x = 2; x < 30; ++x) {
      const int first = 12 + std::abs(y - 14);
      if (x < first || x >= first + open) course.walls[course.index({x, y})] = 1;
    }
  course.start = {6, 22};
  course.goal = {20, 5};
  return course;
}

TEST(PoseCells, ProveThatABendWhichTheCarFillsSquarelyIsNoWayForSquares) {
  for (const int open : {4, 5}) {
    const Course course = bent_lane(open);
    const detail::PoseCells squares(detail::Obstacles(course, 0, WallReading::squares), course.goal);
    EXPECT_EQ(squares.reaches({6, 22, 0}), open == 5) << "4 wide: straight down the car is 2 wide in 2, or 3 long in 3";
    EXPECT_TRUE(squares.reaches({20, 7, 1}));
    const detail::PoseCells points(detail::Obstacles(course, 0, WallReading::points), course.goal);
    EXPECT_TRUE(points.reaches({6, 22, 0})) << "steps may turn past the place";
    LatticePlanner planner(course, WallReading::squares);
    EXPECT_EQ(planner.plan({6, 22, 0}, 0) != nullptr, open == 5);
    EXPECT_FALSE(planner.gave_up({6, 22, 0}, 0));
  }
}

TEST(PoseCells, LeaveItUnprovenWhereOnlyTheLatticeHasNoWay) {
  const std::vector<std::string> rows{"################", "#.#.......#....#", "#...#..........#", "#.#............#",
                                      "#..........#...#", "#..............#", "#........#.....#", "#...........#..#",
                                      "#.....#........#", "#...........#..#", "#..............#", "################"};
  Course course = walled_room(16, 12);
  for (int y = 1; y <= 12; ++y)
    for (int x = 1; x <= 16; ++x)
      course.walls[course.index({x, y})] =
          rows[static_cast<std::size_t>(12 - y)][static_cast<std::size_t>(x - 1)] == '#';
  course.start = {4, 4};
  course.goal = {13, 9};
  const detail::PoseCells cells(detail::Obstacles(course, 0, WallReading::squares), course.goal);
  ASSERT_TRUE(cells.reaches({4, 4, 0}));
  LatticePlanner planner(course, WallReading::squares);
  ASSERT_EQ(planner.plan({4, 4, 0}, 0), nullptr);
  ASSERT_LT(planner.expanded(), 600'000U) << "searched to the end";
  EXPECT_TRUE(planner.gave_up({4, 4, 0}, 0));
}

TEST(PoseCells, KnowTheWayAroundOutsideOfAGridWithoutBorder) {
  Course course = walled_room(30, 15);
  for (std::uint8_t& wall : course.walls) wall = 0;
  for (int y = 1; y <= 15; ++y) course.walls[course.index({15, y})] = 1;
  course.goal = {25, 7};
  EXPECT_TRUE(detail::PoseCells(detail::Obstacles(course, 0, WallReading::points), course.goal).reaches({6, 7, 0}));
}

}  // namespace
}  // namespace taut::roadblocks
