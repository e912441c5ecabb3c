#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/maze_generator.h>
#include <taut/search/distance_matrix.h>
#include <taut/search/shortest_path.h>

#include "support/refusal.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;
using testing::ElementsAre;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(DistanceMatrix, LeadsAroundTheFreeEndOfAWall) {
  const SmallWorld world{.walls = {{{5, 0}, {5, 4}}}};
  const std::vector<Point> points{{2, 0}, {8, 0}, {2, 8}};
  EXPECT_THAT(distance_matrix(world.space(), points),
              ElementsAre(0, 10, 8, 10, 0, std::hypot(8 - 2, 8), 8, std::hypot(8 - 2, 8), 0));
}

TEST(DistanceMatrix, IsInfiniteBetweenRooms) {
  const SmallWorld world{.walls = {{{5, 0}, {5, 10}}}};
  const std::vector<Point> points{{2, 5}, {8, 5}};
  EXPECT_THAT(distance_matrix(world.space(), points), ElementsAre(0, kInfinity, kInfinity, 0));
}

TEST(DistanceMatrix, KnowsBothSidesOfAPointOnAWall) {
  const SmallWorld world{.walls = {{{5, 0}, {5, 10}}}};
  const std::vector<Point> points{{2, 5}, {8, 5}, {5, 5}};
  EXPECT_THAT(distance_matrix(world.space(), points), ElementsAre(0, kInfinity, 3, kInfinity, 0, 3, 3, 3, 0));
}

TEST(DistanceMatrix, TakesPointsThatRepeatAndNone) {
  const SmallWorld world{};
  EXPECT_THAT(distance_matrix(world.space(), std::vector<Point>{{1, 1}, {4, 5}, {1, 1}}),
              ElementsAre(0, 5, 0, 5, 0, 5, 0, 5, 0));
  EXPECT_TRUE(distance_matrix(world.space(), std::vector<Point>{}).empty());
}

TEST(DistanceMatrix, RefusesAPointInAnObstacle) {
  const SmallWorld world{.solids = {test::box_ring(2, 2, 4, 4)}};
  EXPECT_THAT(test::refusal_of([&] {
                distance_matrix(world.space(), std::vector<Point>{{1, 1}, {3, 3}});
              }),
              testing::HasSubstr("point (3, 3) lies 1 inside"));
}

TEST(DistanceMatrix, SaysHowManyRowsAreFinal) {
  const FreeSpace space = SmallWorld{.walls = {{{5, 0}, {5, 4}}}}.space();
  std::vector<Point> points;
  for (int n = 0; n < 20; ++n) points.push_back({0.5 * n, 1});
  std::vector<double> lengths(400, -1);
  std::vector<std::size_t> told;
  distance_matrix(VisibilityGraph(space), points, lengths, [&](std::size_t rows) {
    told.push_back(rows);
    for (std::size_t at = 0; at < 20 * rows; ++at) EXPECT_GE(lengths[at], 0) << "row " << at / 20;
  });
  EXPECT_THAT(told, ElementsAre(8, 16, 20));
}

/// Where many ways to a corner are equally long the one that is kept decides nothing.
TEST(DistanceMatrix, IsExactWhereManyWaysTie) {
  SmallWorld world;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) world.solids.push_back(test::box_ring(2 * x + 1, 2 * y + 1, 2 * x + 2, 2 * y + 2));
  world.area = test::box_ring(0, 0, 13, 13);
  const FreeSpace space = world.space();
  const VisibilityGraph graph(space);
  const std::vector<Point> points{{0, 0}, {13, 13}, {0.5, 12.5}, {6, 6.5}, {12.5, 0.5}, {7, 3}, {3, 8}};
  const std::vector<double> lengths = distance_matrix(space, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j)
      EXPECT_EQ(lengths[i * points.size() + j], shortest_path(graph, points[i], {points[j], {}}).path.length.value());
}

TEST(DistanceMatrix, HasTheLengthsOfSinglePathsInAMazeWithLoops) {
  auto maze = std::make_shared<GridMaze>(generate_backtracker(30, 30, 3));
  open_walls(*maze, 0.2, 3);
  const FreeSpace space(world_of(std::move(maze)));
  const VisibilityGraph graph(space);
  std::vector<Point> points;
  for (int n = 0; n < 40; ++n) points.push_back({(n * 7) % 30 + 0.5, (n * 11) % 30 + 0.25});
  const std::vector<double> lengths = distance_matrix(space, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ShortestPathTree tree(std::make_shared<const VisibilityGraph>(graph), points[i]);
    for (std::size_t j = 0; j < points.size(); ++j)
      EXPECT_EQ(lengths[i * points.size() + j], tree.path_to(points[j])->length.value());
  }
}

std::vector<Point> points_in(int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) points.push_back({1 + (i * 7 % 18) / 2.0, 1 + (i * 11 % 17) / 2.0});
  return points;
}

TEST(DistanceMatrix, IsTheSameForAnyNumberOfThreads) {
  const SmallWorld world{.walls = {{{5, 0}, {5, 4}}, {{2, 6}, {9, 7}}}};
  const std::vector<Point> points = points_in(50);
  const std::vector<double> one = distance_matrix(world.space(), points);
  EXPECT_EQ(distance_matrix(world.space(), points, 2), one);
  EXPECT_EQ(distance_matrix(world.space(), points, 7), one);
}

TEST(DistanceRows, PutTogetherInAnyOrderAreTheMatrix) {
  const SmallWorld world{.walls = {{{5, 0}, {5, 4}}, {{2, 6}, {9, 7}}}};
  const std::vector<Point> points = points_in(21);  // two groups of eight and one of five
  const VisibilityGraph graph(world.space());
  const DistanceRows rows(graph, points);
  ASSERT_EQ(rows.groups(), 3U);
  const auto measure = rows.worker();
  std::vector<double> whole(points.size() * points.size());
  for (const std::size_t group : {1, 2, 0}) put_rows(group, measure(group), whole, points.size());
  EXPECT_EQ(whole, distance_matrix(world.space(), points));
  EXPECT_EQ(measure(2).size(), 5U + 4 + 3 + 2 + 1) << "from the diagonal on";
}

}  // namespace
}  // namespace taut
