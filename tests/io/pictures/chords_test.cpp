// Two chords a bend, which no path gets around.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include <taut/geometry/maze_generator.h>
#include <taut/io/pictures/chords.h>
#include <taut/search/shortest_path.h>

#include "support/small_world.h"

namespace taut {
namespace {

TEST(Chords, AreTwoABendAndStraightAcrossItsLegs) {
  const FreeSpace space = test::SmallWorld{{{{5, 0}, {5, 4}}}}.space();
  const auto path = shortest_path(space, {2, 0}, Point{8, 0});
  const auto found = chords(space, *path);
  ASSERT_EQ(found.size(), 2U);
  for (const Segment& s : found) EXPECT_EQ(s.a, (Point{5, 4}));
  EXPECT_EQ(found[0].b, (Point{0, 7.75})) << "across the leg from (2, 0), which rises 4 on 3";
  EXPECT_EQ(found[1].b, (Point{10, 7.75}));
}

TEST(Chords, AreNoneWhereAWallStandsFree) {
  const std::vector<Segment> walls{{{5, 0}, {5, 4}}, {{5, 5}, {5, 6}}};
  const FreeSpace space = test::SmallWorld{walls}.space();
  EXPECT_TRUE(chords(space, *shortest_path(space, {2, 0}, Point{8, 0})).empty());
}

TEST(Chords, OfAMazeSeparateStartFromGoal) {
  const World maze = world_of(std::make_shared<const GridMaze>(generate_backtracker(9, 9, 4)));
  const Point from{0.5, 0.5}, to{8.5, 8.5};
  const FreeSpace space(maze);
  const auto path = shortest_path(space, from, to);
  const auto found = chords(space, *path);
  ASSERT_EQ(found.size(), 2 * (path->points.size() - 2));
  ASSERT_GT(found.size(), 10U);
  for (const Segment& s : found) {
    WorldParts parts = maze.parts();
    parts.walls.push_back({s.a, {s.b.x + (s.b.x - s.a.x) * 1e-9, s.b.y + (s.b.y - s.a.y) * 1e-9}, 0, 0});
    EXPECT_FALSE(shortest_path(FreeSpace(World(parts)), from, to)) << s.a.x << ' ' << s.a.y;
  }
}

}  // namespace
}  // namespace taut
