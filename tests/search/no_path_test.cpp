#include <taut/search/no_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include <taut/io/worlds/read_world.h>
#include <taut/search/shortest_path.h>

namespace taut {
namespace {

FreeSpace space_of(const std::string& text, Footprint robot = Footprint::point()) {
  return FreeSpace(read_world(text, ReadOptions{.source = "world.txt"}), std::move(robot));
}

Goal to(Point p) { return {p, {}}; }
Goal into(Box box) { return {std::nullopt, {box}}; }

// Two rooms side by side; the wall between them is x = 2.
constexpr const char* kTwoRooms = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 4\n";

TEST(NoPath, IsProvenByTheWallBetweenTwoRooms) {
  const NoPath proof(space_of(kTwoRooms));
  EXPECT_TRUE(proof.holds({1, 1}, to({3, 1})));
  const auto walls = proof.walls({1, 1}, to({3, 1}));
  ASSERT_TRUE(walls);
  EXPECT_FALSE(walls->empty());
}

TEST(NoPath, IsNotProvenWhereThereIsAPath) {
  const NoPath proof(space_of("0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\n"));
  EXPECT_FALSE(proof.holds({1, 1}, to({3, 1})));
  EXPECT_FALSE(proof.walls({1, 1}, to({3, 1})));
  EXPECT_FALSE(proof.holds({1, 1}, into({{3, 1}, {4, 2}})));
}

TEST(NoPath, IsNotProvenFromAWallThatHasTheGoalOnItsOtherSide) {
  const NoPath proof(space_of(kTwoRooms));
  for (const Point on_wall : {Point{2, 1}, Point{2, 4}, Point{2, 0}}) {
    EXPECT_FALSE(proof.holds(on_wall, to({1, 1}))) << on_wall.y;
    EXPECT_FALSE(proof.holds(on_wall, to({3, 1}))) << on_wall.y;
    EXPECT_FALSE(proof.holds({1, 1}, to(on_wall))) << on_wall.y;
    EXPECT_FALSE(proof.holds({3, 1}, to(on_wall))) << on_wall.y;
  }
}

TEST(NoPath, IntoARoomNeedsMoreThanAWallBeforeItsMiddle) {
  // The box reaches over the wall by a little.
  const NoPath proof(space_of(kTwoRooms));
  EXPECT_FALSE(proof.holds({1, 1}, into({{1.5, 1}, {4, 2}})));
  EXPECT_TRUE(proof.holds({1, 1}, into({{2, 1}, {4, 2}})));
  ASSERT_TRUE(proof.walls({1, 1}, into({{2, 1}, {4, 2}})));
  EXPECT_FALSE(proof.walls({1, 1}, into({{2, 1}, {4, 2}}))->empty());
  EXPECT_FALSE(proof.holds({3, 1}, into({{2, 1}, {4, 2}})));
}

TEST(NoPath, IntoARoomWithItsMiddleInAnObstacleIsProvenByTheWalls) {
  const NoPath proof(space_of(std::string(kTwoRooms) + "2.5 1.5 3.5 1.5 0.5\n"));
  const auto walls = proof.walls({1, 1}, into({{2.5, 1}, {3.5, 2}}));
  ASSERT_TRUE(walls);
  EXPECT_FALSE(walls->empty());
}

TEST(NoPath, IntoARoomFullOfObstaclesNeedsNoWalls) {
  const NoPath proof(space_of(std::string(kTwoRooms) + "3 3 3 3 1\n"));
  const auto walls = proof.walls({1, 1}, into({{2.75, 2.75}, {3.25, 3.25}}));
  ASSERT_TRUE(walls);
  EXPECT_TRUE(walls->empty());
}

// A wall across the room with a gap as wide as given, which lies in the direction of a corner of the polygon around a
// disc as well as of one in the middle of its sides, whichever corners it has.
std::string gap_of(double width, double angle) {
  const double x = std::cos(angle), y = std::sin(angle), far = 20;
  const auto number = [](double v) { return std::to_string(v) + " "; };
  const auto piece = [&](double sign) {
    return number(sign * x * width / 2) + number(sign * y * width / 2) + number(sign * x * far) +
           number(sign * y * far);
  };
  return "boundary -9 -9 9 9\n" + piece(1) + "\n" + piece(-1) + "\n";
}

TEST(NoPath, OfADiscIsNotProvenByThePolygonAroundIt) {
  // 2.001: wider than the disc of radius 1, narrower than the corners of the polygon around it (2.0024).
  int apart = 0;
  for (const double step : {0.0, 0.5}) {
    const double angle = std::numbers::pi / 32 * (6 + step);
    const FreeSpace space = space_of(gap_of(2.001, angle), Footprint::disc(1));
    const Point start{5 * std::sin(angle), -5 * std::cos(angle)}, goal{-start.x, -start.y};
    apart += !shortest_path(space, start, goal);
    EXPECT_FALSE(NoPath(space).holds(start, to(goal))) << step;
  }
  EXPECT_EQ(apart, 1);
}

TEST(NoPath, OfADiscIsProvenWhereNotEvenThePolygonInsideItGetsThrough) {
  for (const double step : {0.0, 0.5}) {
    const double angle = std::numbers::pi / 32 * (6 + step);
    const NoPath proof(space_of(gap_of(1.9, angle), Footprint::disc(1)));
    const Point start{5 * std::sin(angle), -5 * std::cos(angle)}, goal{-start.x, -start.y};
    EXPECT_TRUE(proof.holds(start, to(goal))) << step;
    ASSERT_TRUE(proof.walls(start, to(goal)));
    EXPECT_FALSE(proof.walls(start, to(goal))->empty());
  }
}

}  // namespace
}  // namespace taut
