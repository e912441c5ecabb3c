// Polyanya with a graph: from bend to bend, exactly as long as cones of sight and as the visibility graph have it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>

#include <taut/geometry/maze_generator.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/random_world.h"
#include "support/small_world.h"
#include "support/turned.h"

namespace taut {
namespace {

using namespace test;
using testing::ElementsAre;

World opened_maze(int cells, double opened) {
  auto grid = std::make_shared<GridMaze>(generate_backtracker(cells, cells, 5));
  open_walls(*grid, opened, 5);
  return world_of(std::move(grid));
}

/// How many pairs were asked.
int expect_agreement(const FreeSpace& space, int cells, const std::function<Point(Point)>& turn) {
  const Polyanya plain(space);
  PolyanyaSearch cones(plain), bends(plain.with_graph()), both(plain.with_graph().with_landmarks(4));
  int asked = 0;
  for (int n = 0; n < 300; ++n) {
    const auto coordinate = [&](int k) { return (k * 37 + n * 101) % (4 * cells + 1) / 4.0; };
    const Point from = turn({coordinate(1), coordinate(5 + n % 7)}),
                to = turn({coordinate(11), coordinate(17 + n % 3)});
    if (space.locate(from).kind == Location::Kind::outside || space.locate(to).kind == Location::Kind::outside)
      continue;
    ++asked;
    EXPECT_EQ(cones.find(from, to), SearchStatus::found);
    const Length expected = cones.result().path.length;
    for (PolyanyaSearch* search : {&bends, &both}) {
      EXPECT_EQ(search->find(from, to), SearchStatus::found);
      EXPECT_EQ(search->result().path.length, expected) << show(from) << " to " << show(to);
      EXPECT_NEAR(search->length(), expected.value(), 1e-9);
      EXPECT_TRUE(verify(search->result().path, space, from, {to, {}}).valid) << show(from) << " to " << show(to);
    }
  }
  return asked;
}

TEST(BendSearch, HasTheShortestPathsOfMazesWithLoops) {
  const auto stay = [](Point p) { return p; };
  EXPECT_GT(expect_agreement(FreeSpace(opened_maze(15, 0.3)), 15, stay), 250);
  EXPECT_GT(expect_agreement(FreeSpace(opened_maze(15, 0.3).with_wall_thickness(0.25)), 15, stay), 60);
}

TEST(BendSearch, HasThemOffEveryLattice) {
  const Turn turn(31.4);
  WorldParts parts = opened_maze(12, 0.3).with_wall_thickness(0.125).parts();
  parts.goal = {};
  const FreeSpace space{World(turn(std::move(parts)))};
  EXPECT_TRUE(space.triangulation().lattice.empty());
  EXPECT_GT(expect_agreement(space, 12, [&](Point p) { return turn(p); }), 60);
}

TEST(BendSearch, DecidesTiesExactly) {
  // Around the block both ways are equally long; a third, by 2^-40 shorter, is the one.
  const double shift = 0x1p-40;
  const SmallWorld even{.solids = {box_ring(4, 3, 6, 7)}}, uneven{.solids = {box_ring(4, 3, 6, 7 - shift)}};
  for (const SmallWorld& world : {even, uneven}) {
    const FreeSpace space = world.space();
    PolyanyaSearch search{Polyanya(space).with_graph()};
    ASSERT_EQ(search.find({1, 5}, {9, 5}), SearchStatus::found);
    EXPECT_EQ(search.result().path.length, shortest_path(space, {1, 5}, Point{9, 5})->length);
  }
  PolyanyaSearch search{Polyanya(uneven.space()).with_graph()};
  search.find({1, 5}, {9, 5});
  EXPECT_THAT(search.points(), ElementsAre(Point{1, 5}, Point{4, 7 - shift}, Point{6, 7 - shift}, Point{9, 5}));
}

TEST(BendSearch, LeavesOutPointsInAStraightLine) {
  // Three blocks whose corners are in line with both ends.
  const SmallWorld world{.solids = {box_ring(2, 2, 3, 5), box_ring(4, 2, 5, 5), box_ring(6, 2, 7, 5)}};
  PolyanyaSearch search{Polyanya(world.space()).with_graph()};
  search.find({1, 4}, {8, 4});
  EXPECT_THAT(search.points(), ElementsAre(Point{1, 4}, Point{2, 5}, Point{7, 5}, Point{8, 4}));
}

TEST(BendSearch, KnowsThatThereIsNoPath) {
  const SmallWorld world{.walls = {{{5, 0}, {5, 10}}}, .solids = {box_ring(1, 1, 2, 2)}};
  PolyanyaSearch search{Polyanya(world.space()).with_graph().with_landmarks(2)};
  EXPECT_EQ(search.find({3, 5}, {8, 5}), SearchStatus::none);
  EXPECT_TRUE(search.points().empty());
  EXPECT_EQ(search.find({5, 5}, {8, 5}), SearchStatus::found) << "from the wall itself, to its other side";
  EXPECT_EQ(search.find({3, 5}, {0.5, 0.5}), SearchStatus::found);
  EXPECT_EQ(search.find({3, 5}, {3, 5}), SearchStatus::found);
  EXPECT_THAT(search.points(), ElementsAre(Point{3, 5}));
}

TEST(BendSearch, LooksAtLess) {
  const FreeSpace space(opened_maze(40, 0.2));
  const Polyanya plain(space);
  std::size_t expanded[2] = {0, 0};
  PolyanyaSearch searches[2] = {PolyanyaSearch(plain), PolyanyaSearch(plain.with_graph().with_landmarks())};
  for (int i = 0; i < 2; ++i)
    for (int n = 0; n < 40; ++n) {
      searches[i].find({n + 0.5, 0.5}, {39.5 - n, 39.5});
      expanded[i] += searches[i].expanded();
    }
  EXPECT_LT(2 * expanded[1], expanded[0]);
}

}  // namespace
}  // namespace taut
