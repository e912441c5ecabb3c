#include <taut/geometry/world.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "support/refusal.h"

namespace taut {
namespace {

Ring box_ring(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

std::string message_of(const WorldParts& parts) {
  return test::refusal_of([&] { const World world(parts); });
}

// +---+
//     |   two openings of length 1: left below, right above
// +---+
WorldParts room_with_two_gaps() {
  WorldParts parts;
  parts.walls = {{{0, 0}, {4, 0}}, {{0, 3}, {4, 3}}, {{0, 1}, {0, 3}}, {{4, 0}, {4, 2}}};
  return parts;
}

TEST(World, WithoutWallsAndAreasIsRefused) { EXPECT_EQ(message_of({}), "no walls and no areas"); }

TEST(World, TakesTheBoxOfWallsThatCoverHalfOfItAsTheLimit) {
  const World world(room_with_two_gaps());
  EXPECT_EQ(world.boundary(), Boundary::limit);
  EXPECT_EQ(world.box(), (Box{{0, 0}, {4, 3}}));
  ASSERT_EQ(world.areas().size(), 1U);
  EXPECT_EQ(world.areas()[0].polygon.outer, box_ring(0, 0, 4, 3));
}

TEST(World, GoesFromOpeningToOpening) {
  const World world(room_with_two_gaps());
  ASSERT_EQ(world.openings().size(), 2U);
  EXPECT_EQ(world.openings()[0], (Segment{{4, 2}, {4, 3}}));
  EXPECT_EQ(world.openings()[1], (Segment{{0, 1}, {0, 0}}));
  EXPECT_EQ(world.start(), (Point{0, 0.5}));
  EXPECT_EQ(world.goal().point, (Point{4, 2.5}));
}

TEST(World, LeavesGivenEndsAlone) {
  WorldParts parts = room_with_two_gaps();
  parts.start = Point{1, 1};
  const World world(parts);
  EXPECT_EQ(world.start(), (Point{1, 1}));
  EXPECT_FALSE(world.goal().point);
}

TEST(World, SetsNoEndsWithThreeOpenings) {
  WorldParts parts = room_with_two_gaps();
  parts.walls[1].b = {3, 3};
  const World world(parts);
  EXPECT_EQ(world.openings().size(), 3U);  // a corner separates two of them
  EXPECT_FALSE(world.start());
}

TEST(World, CountsOverlappingWallsOfTheOutlineOnce) {
  WorldParts parts = room_with_two_gaps();
  parts.walls.push_back({{3, 0}, {1, 0}});
  parts.walls.push_back({{-0.0, 2}, {0, 3}});
  EXPECT_EQ(World(parts).openings().size(), 2U);
}

TEST(World, DoesNotTakeAWallThatOnlyCrossesTheOutlineForACover) {
  WorldParts parts = room_with_two_gaps();
  parts.areas = {{{box_ring(0, 0, 4, 3), {}}, 0}};
  parts.walls.push_back({{3, 2.5}, {5, 2.5}});
  EXPECT_EQ(World(parts).openings().size(), 2U);
}

TEST(World, JoinsOpeningsAcrossStraightVertices) {
  WorldParts parts;
  parts.areas = {{{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}}, {}}, 0}};
  const World world(parts);
  ASSERT_EQ(world.openings().size(), 4U);
  EXPECT_EQ(world.openings()[0], (Segment{{0, 0}, {2, 0}}));
}

TEST(World, KnowsThatASeamBetweenTwoAreasIsNoOpening) {
  WorldParts parts;
  parts.areas = {{{box_ring(0, 0, 2, 2), {}}, 0}, {{box_ring(2, 1, 4, 2), {}}, 0}};
  const World world(parts);
  for (const Segment& s : world.openings()) EXPECT_FALSE(s.a.x == 2 && s.b.x == 2 && std::max(s.a.y, s.b.y) > 1);
}

TEST(World, IsOpenAroundFewWallsWithRoomOnAllSides) {
  WorldParts parts;
  parts.walls = {{{0, 0}, {8, 0}}};
  parts.start = Point{4, -1};
  parts.goal.point = Point{4, 3};
  const World world(parts);
  EXPECT_EQ(world.boundary(), Boundary::open);
  EXPECT_EQ(world.box(), (Box{{-4, -4}, {12, 6}}));
  EXPECT_TRUE(world.openings().empty());
}

TEST(World, KeepsTheOpenBoxOnCoarseDyadicNumbers) {
  WorldParts parts;
  parts.walls = {{{0.5, 0.5}, {7.5, 5.5}}};
  const Box box = World(parts).box();
  for (double v : {box.min.x, box.min.y, box.max.x, box.max.y}) EXPECT_EQ(v, std::floor(v));
}

TEST(World, WidensTheOpenBoxWhenEndsMoveOutOfIt) {
  WorldParts parts;
  parts.walls = {{{0, 0}, {8, 0}}};
  const World world = World(parts).with_ends(Point{100, 100}, std::nullopt);
  EXPECT_GT(world.box().max.x, 100);
  EXPECT_GT(world.box().max.y, 100);
  EXPECT_EQ(world.start(), (Point{100, 100}));
}

// An end outside shows that the walls are no limit.
TEST(World, HasAnImpliedLimitThatYieldsToAnEndBeyondIt) {
  const World world(room_with_two_gaps()), wider = world.with_ends(Point{-9, -9}, std::nullopt);
  EXPECT_EQ(world.box(), (Box{{0, 0}, {4, 3}}));
  EXPECT_EQ(wider.boundary(), Boundary::open);
  EXPECT_TRUE(wider.box().contains({-9, -9}));
  EXPECT_EQ(wider.goal().point, (Point{4, 2.5}));
}

TEST(World, IsOpenAroundATrapWhenAnEndLiesBeyondItsBareSide) {
  WorldParts parts;
  parts.walls = {{{0, 0}, {4, 0}, 0, 0}, {{4, 0}, {4, 4}, 0, 0}, {{4, 4}, {0, 4}, 0, 0}};
  parts.start = Point{2, 2};
  EXPECT_EQ(World(parts).boundary(), Boundary::limit);
  EXPECT_EQ(World(parts).with_ends(std::nullopt, Point{6, 2}).boundary(), Boundary::open);
  parts.goal.point = Point{6, 2};
  EXPECT_EQ(World(parts).boundary(), Boundary::open);
}

TEST(World, WidensTheOpenBoxByTheSmallestStepWhereDoublesAreCoarse) {
  WorldParts parts;
  const double huge = 0x1p70;
  parts.walls = {{{huge, huge}, {std::nextafter(huge, 2 * huge), huge}}};
  const World world(parts);
  EXPECT_LT(world.box().min.x, huge);
  EXPECT_GT(world.box().max.y, huge);
}

TEST(World, RefusesAnOpenBoxBeyondTheLargestCoordinate) {
  WorldParts parts;
  parts.walls = {{{-1e75, 0}, {1e75, 0}}};
  EXPECT_EQ(message_of(parts), "no boundary is given, and one around everything would reach beyond 1e+75");
}

TEST(World, DropsZeroLengthWallsWithoutThickness) {
  WorldParts parts = room_with_two_gaps();
  parts.walls.push_back({{1, 1}, {1, 1}, 0});
  parts.walls.push_back({{2, 1}, {2, 1}, 0.5});
  const World world(parts);
  EXPECT_EQ(world.dropped_walls(), 1U);
  EXPECT_EQ(world.walls().size(), 5U);
  EXPECT_EQ(world.with_wall_thickness(0).dropped_walls(), 2U);
  EXPECT_EQ(world.with_wall_thickness(0.25).walls()[4].thickness, 0.25);
}

TEST(World, NamesSourceLineAndValueOfABadCoordinate) {
  WorldParts parts = room_with_two_gaps();
  parts.source = "cellar.txt";
  parts.walls[2].line = 7;
  parts.walls[2].a.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of(parts), "cellar.txt:7: coordinate nan is not a finite number");
  parts.walls[2].a.x = -1e76;
  EXPECT_EQ(message_of(parts), "cellar.txt:7: coordinate -1e+76 is beyond 1e+75");
  parts.walls[2].a.x = 0;
  parts.walls[2].thickness = -2;
  EXPECT_EQ(message_of(parts), "cellar.txt:7: wall thickness -2 is negative");
}

TEST(World, ChecksStartGoalAndThicknessGivenLater) {
  const World world(room_with_two_gaps());
  EXPECT_THROW(world.with_ends(Point{INFINITY, 0}, std::nullopt), InputError);
  EXPECT_THROW(world.with_ends(std::nullopt, Point{0, 1e300}), InputError);
  EXPECT_THROW(world.with_wall_thickness(-1), InputError);
  EXPECT_THROW(world.with_wall_thickness(NAN), InputError);
}

TEST(World, CutsAGoalRoomThatReachesBeyondItsBoundary) {
  WorldParts parts;
  parts.areas = {{{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {}}, 0}};
  parts.goal.room = {{{2, 2}, {3, 5}}, {{1, 1}, {2, 2}}, {{-5, 1}, {9, 2}}, {{3, 0}, {4, 1}}, {{7, 7}, {8, 8}}};
  const Goal goal = World(parts).goal();
  ASSERT_EQ(goal.room.size(), 3u) << "what only touches the boundary is no place to enter";
  EXPECT_EQ(goal.room[0].min, (Point{2, 2}));
  EXPECT_EQ(goal.room[0].max, (Point{3, 3}));
  EXPECT_EQ(goal.room[1].max, (Point{2, 2}));
  EXPECT_EQ(goal.room[2].min, (Point{0, 1}));
  EXPECT_EQ(goal.room[2].max, (Point{3, 2}));
  parts.goal.room = {{{3, 0}, {4, 1}}};
  EXPECT_THROW(World{parts}, InputError);
}

TEST(World, IsOpenWhenARoomReachesBeyondItsBareSide) {
  WorldParts parts;
  parts.walls = {{{0, 0}, {3, 0}}, {{3, 0}, {3, 3}}, {{0, 3}, {0, 0}}};
  parts.start = Point{1, 1};
  parts.goal.room = {{{1, 2}, {2, 5}}};
  const World world(parts);
  EXPECT_EQ(world.boundary(), Boundary::open);
  EXPECT_EQ(world.goal().room[0].max, (Point{2, 5}));
}

TEST(World, ReplacesARoomByAGoalPoint) {
  const World world = world_of(std::make_shared<const GridMaze>([] {
                        GridMaze maze(2, 2, false);
                        maze.goal = {{1, 1}};
                        return maze;
                      }()))
                          .with_ends(std::nullopt, Point{0.5, 1.5});
  EXPECT_EQ(world.goal().point, (Point{0.5, 1.5}));
  EXPECT_TRUE(world.goal().room.empty());
}

TEST(WorldOfGrid, MergesWallsIntoMaximalRuns) {
  GridMaze maze(3, 2, false);
  maze.set_wall({0, 0}, Side::north, true);
  maze.set_wall({1, 0}, Side::north, true);
  maze.set_wall({1, 1}, Side::east, true);
  maze.goal = {{2, 1}};
  const World world = world_of(std::make_shared<const GridMaze>(maze), 2);
  ASSERT_EQ(world.walls().size(), 6U);
  EXPECT_EQ(world.walls()[1].a, (Point{0, 2}));
  EXPECT_EQ(world.walls()[1].b, (Point{4, 2}));
  EXPECT_EQ(world.walls()[4].a, (Point{4, 2}));
  EXPECT_EQ(world.walls()[4].b, (Point{4, 4}));
  EXPECT_EQ(world.box(), (Box{{0, 0}, {6, 4}}));
  EXPECT_EQ(world.boundary(), Boundary::limit);
  EXPECT_EQ(world.start(), (Point{1, 1}));
  ASSERT_EQ(world.goal().room.size(), 1U);
  EXPECT_EQ(world.goal().room[0], (Box{{4, 2}, {6, 4}}));
  EXPECT_EQ(*world.grid(), maze);
}

TEST(WorldOfGrid, GoesFromOpeningToOpeningWithoutAGoal) {
  GridMaze maze(3, 2, false);
  maze.set_wall({0, 0}, Side::west, false);
  maze.set_wall({2, 1}, Side::east, false);
  const World world = world_of(std::make_shared<const GridMaze>(maze));
  EXPECT_EQ(world.start(), (Point{0, 0.5}));
  EXPECT_EQ(world.goal().point, (Point{3, 1.5}));
}

TEST(WorldOfGrid, StartsInTheStartCellWithoutGoalAndOpenings) {
  const World world = world_of(std::make_shared<const GridMaze>(GridMaze(2, 2, true)));
  EXPECT_EQ(world.start(), (Point{0.5, 0.5}));
  EXPECT_FALSE(world.goal().point);
}

}  // namespace
}  // namespace taut
