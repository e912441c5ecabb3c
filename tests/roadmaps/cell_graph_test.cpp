#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>

#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/cell_graph.h>
#include <taut/search/cell_search.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

//  o---o---o---o
//  |       | G |
//  o   o   o   o     Walls on half-integers: posts at (0.5, 0.5), (1.5, 0.5), ...
//  | S         |
//  o---o---o---o
constexpr const char* kTwoByThree =
    "0.5 0.5 3.5 0.5\n3.5 0.5 3.5 2.5\n3.5 2.5 0.5 2.5\n0.5 2.5 0.5 0.5\n2.5 1.5 2.5 2.5\nstart 1 1\ngoal 3 2\n";

World world(const std::string& text) { return read_world(text); }
CellGraph cells(const std::string& text, CellNeighbours neighbours = CellNeighbours::four) {
  return CellGraph(FreeSpace(world(text)), neighbours);
}

std::string why_not(const std::string& text) {
  return test::refusal_of([&] { cell_lattice(world(text)); });
}

TEST(CellGraph, FindsTheLatticeThatWallsStandOn) {
  EXPECT_EQ(cell_lattice(world(kTwoByThree)), (CellLattice{{0.5, 0.5}, 1, 3, 2}));
  EXPECT_EQ(cell_lattice(world(kTwoByThree).with_wall_thickness(0.1)), (CellLattice{{0.5, 0.5}, 1, 3, 2}));
}

TEST(CellGraph, TakesTheCellsOfAGrid) {
  const World grid = world_of(std::make_shared<GridMaze>(4, 3, false), 0.18);
  EXPECT_EQ(cell_lattice(grid).width, 4);
  EXPECT_EQ(cell_lattice(grid).height, 3);
  EXPECT_DOUBLE_EQ(cell_lattice(grid).side, 0.18);
  EXPECT_EQ(CellGraph(FreeSpace(grid)).roadmap().edge_count(), 17U);
}

TEST(CellGraph, JoinsCentresThatSeeEachOther) {
  const CellGraph graph = cells(kTwoByThree);
  EXPECT_THAT(graph.roadmap().points(),
              ElementsAre(Point{1, 1}, Point{1, 2}, Point{2, 1}, Point{2, 2}, Point{3, 1}, Point{3, 2}));
  EXPECT_EQ(graph.roadmap().edge_count(), 6U);
  EXPECT_FALSE(graph.roadmap().adjacent(graph.vertex_of({1, 1}), graph.vertex_of({2, 1})));
  EXPECT_TRUE(graph.roadmap().adjacent(graph.vertex_of({1, 0}), graph.vertex_of({2, 0})));
}

TEST(CellGraph, GoesDiagonallyPastTheEndOfAWallButNotThroughAJoint) {
  const CellGraph open = cells(kTwoByThree, CellNeighbours::eight);
  EXPECT_TRUE(open.roadmap().adjacent(open.vertex_of({1, 0}), open.vertex_of({2, 1})));  // touches the free end
  // A wall from the left as well: now (2.5, 1.5) is a joint with walls to the north and to the west.
  const CellGraph joint = cells(std::string("1.5 1.5 2.5 1.5\n") + kTwoByThree, CellNeighbours::eight);
  EXPECT_FALSE(joint.roadmap().adjacent(joint.vertex_of({1, 1}), joint.vertex_of({2, 0})));
  EXPECT_TRUE(joint.roadmap().adjacent(joint.vertex_of({1, 0}), joint.vertex_of({2, 1})) ==
              joint.space().sees({2, 1}, {3, 2}));
}

TEST(CellGraph, LeavesOutCellsWhereTheRobotCannotStand) {
  const World narrow = world(std::string("1.25 1 1.25 2 1\n") + kTwoByThree);
  EXPECT_THROW(CellGraph{FreeSpace(narrow)}, InputError);  // a wall off the lattice
  const CellGraph thick(FreeSpace(world(kTwoByThree).with_wall_thickness(0.5), Footprint::square(0.3)));
  EXPECT_EQ(thick.roadmap().vertex_count(), 0U);
  EXPECT_EQ(thick.vertex_of({0, 0}), kNone);
}

TEST(CellGraph, JoinsAPointToTheCellsItLiesInOrElseToTheNearestItSees) {
  const CellGraph graph = cells(kTwoByThree);
  EXPECT_THAT(graph.joined_to({0.75, 1.25}), ElementsAre(graph.vertex_of({0, 0})));
  EXPECT_THAT(graph.joined_to({1.5, 1.25}), ElementsAre(graph.vertex_of({0, 0}), graph.vertex_of({1, 0})));
  EXPECT_THAT(graph.joined_to({1.5, 1.5}).size(), 4U);
  // Behind the corner of a block that fills its own cell's middle, only a neighbour is seen.
  const CellGraph blocked(FreeSpace(world(std::string("0.5 1.5 1.5 1.5\n") + kTwoByThree).with_wall_thickness(0.9)));
  EXPECT_THAT(blocked.joined_to({2, 1}), ElementsAre(blocked.vertex_of({1, 0})));
}

TEST(CellGraph, RefusesWorldsWithoutCellsAndNamesTheCulprit) {
  EXPECT_THAT(why_not(std::string(kTwoByThree) + "1 1 2 1.5\n"), HasSubstr("line 8: has no cells: the wall (1, 1) to"));
  EXPECT_THAT(why_not(std::string(kTwoByThree) + "1 1 2 1\n"), HasSubstr("does not end at a post"));
  EXPECT_THAT(why_not("0 0 1 0\n5 5 5 6\nstart 0 0\ngoal 9 9\n"), HasSubstr("the world is not one box"));
}

TEST(CellGraph, IsRestoredFromItsRoadmapAndOnlyFromItsOwn) {
  const CellGraph graph = cells(kTwoByThree, CellNeighbours::eight);
  const CellGraph again(graph.space(), CellNeighbours::eight, graph.roadmap());
  EXPECT_EQ(again.roadmap(), graph.roadmap());
  EXPECT_EQ(again.vertex_of({2, 1}), graph.vertex_of({2, 1}));
  EXPECT_THROW(CellGraph(graph.space(), CellNeighbours::eight, Roadmap{}), InputError);
}

TEST(CellSearch, IsAFreePathNeverShorterThanTheShortest) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    GridMaze grid = generate_biased_maze(11, 14, seed);
    open_walls(grid, 0.2, seed);
    const World maze = world_of(std::make_shared<GridMaze>(grid));
    const FreeSpace space(maze);
    const Path best = *shortest_path(space, *maze.start(), maze.goal());
    Length four;
    for (const CellNeighbours neighbours : {CellNeighbours::four, CellNeighbours::eight}) {
      const GraphSearchResult way = cell_search(CellGraph(space, neighbours), *maze.start(), maze.goal());
      ASSERT_EQ(way.status, SearchStatus::found) << seed;
      const Verdict verdict = verify(way.path, space, *maze.start(), maze.goal());
      EXPECT_TRUE(verdict.valid) << seed << ": " << verdict.reason;
      EXPECT_GE(way.path.length, best.length) << seed;
      if (neighbours == CellNeighbours::four)
        four = way.path.length;
      else
        EXPECT_LE(way.path.length, four) << seed;
    }
  }
}

TEST(CellSearch, EntersARoomAcrossItsSide) {
  auto grid = std::make_shared<GridMaze>(6, 6, false);
  grid->goal = centre_room(6, 6);
  const World mouse = world_of(grid);
  const FreeSpace space(mouse);
  const GraphSearchResult way = cell_search(CellGraph(space), *mouse.start(), mouse.goal());
  ASSERT_EQ(way.status, SearchStatus::found);
  EXPECT_TRUE(verify(way.path, space, *mouse.start(), mouse.goal()).valid);
  EXPECT_EQ(way.path.length.value(), 3.5);
}

TEST(CellSearch, IsStraightWithinACellAndNoneWhereAWallSeparates) {
  const CellGraph graph = cells(kTwoByThree);
  EXPECT_EQ(cell_search(graph, {0.75, 1}, Goal{Point{1.25, 1}, {}}).path.length.value(), 0.5);
  const CellGraph sealed = cells(std::string("2.5 0.5 2.5 1.5\n") + kTwoByThree);
  EXPECT_EQ(cell_search(sealed, {1, 1}, Goal{Point{3, 2}, {}}).status, SearchStatus::none);
}

}  // namespace
}  // namespace taut
