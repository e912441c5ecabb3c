// Where one way alone leads: the corridor on trees of polygons against the search on the same mesh, and the graph.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <memory>
#include <optional>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/geometry/maze_generator.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/random_world.h"
#include "support/turned.h"

namespace taut {
namespace {

using namespace test;

World maze(int cells, double opened) {
  auto grid = std::make_shared<GridMaze>(generate_backtracker(cells, cells, 3));
  open_walls(*grid, opened, 3);
  return world_of(std::move(grid));
}

/// One pair, asked of a mesh with trees and of one without.
class TwoRoads {
 public:
  explicit TwoRoads(const FreeSpace& space)
      : space_(space), trees_(Polyanya(space)), portals_(Polyanya(space, navmesh(space))), graph_(space) {}

  void expect_agreement(Point from, Point to) {
    for (const Point p : {from, to})
      if (space_.locate(p).kind == Location::Kind::outside) return;
    ++asked_;
    const SearchStatus expected = portals_.find(from, to);
    ASSERT_EQ(trees_.find(from, to), expected) << show(from) << " to " << show(to);
    if (expected != SearchStatus::found) return;
    const Path path = trees_.result().path;
    EXPECT_EQ(path.length, portals_.result().path.length) << show(from) << " to " << show(to);
    EXPECT_EQ(path.length, shortest_path(graph_, from, {to, {}}).path.length) << show(from) << " to " << show(to);
    EXPECT_NEAR(trees_.length(), path.length.value(), 1e-9);
    const Verdict verdict = verify(path, space_, from, {to, {}});
    EXPECT_TRUE(verdict.valid) << show(from) << " to " << show(to) << ": " << verdict.reason;
  }

  int asked() const { return asked_; }

 private:
  FreeSpace space_;
  int asked_ = 0;
  PolyanyaSearch trees_, portals_;
  VisibilityGraph graph_;
};

void agree_on_fine_points(const World& world, int cells) {
  const FreeSpace space(world);
  TwoRoads roads(space);
  // Middles of cells, corners, places on walls and on portals, and any others.
  for (int n = 0; n < 400; ++n) {
    const auto coordinate = [&](int k) { return (k * 37 + n * 101) % (4 * cells + 1) / 4.0; };
    roads.expect_agreement({coordinate(1), coordinate(5 + n % 7)}, {coordinate(11), coordinate(17 + n % 3)});
  }
  EXPECT_GT(roads.asked(), 100);
}

TEST(Sleeves, HaveTheShortestPathsOfAPerfectMaze) { agree_on_fine_points(maze(12, 0), 12); }

TEST(Sleeves, HaveThemBetweenTheLoopsOfAMaze) { agree_on_fine_points(maze(12, 0.03), 12); }

TEST(Sleeves, HaveThemBetweenThickWalls) { agree_on_fine_points(maze(12, 0).with_wall_thickness(0.25), 12); }

TEST(Sleeves, HaveThemOffEveryLattice) {
  const Turn turn(22.6);
  WorldParts parts = maze(10, 0).with_wall_thickness(0.125).parts();
  parts.goal = {};
  const FreeSpace space{World(turn(std::move(parts)))};
  EXPECT_TRUE(space.triangulation().lattice.empty());
  TwoRoads roads(space);
  for (int n = 0; n < 200; ++n)
    roads.expect_agreement(turn({n % 10 + 0.5, n * 7 % 10 + 0.5}), turn({n * 3 % 10 + 0.5, n * 11 / 10 % 10 + 0.4}));
  EXPECT_EQ(roads.asked(), 200);
}

TEST(Sleeves, AreLeftForTheSearchWhereExpansionsAreLimited) {
  const FreeSpace space(maze(12, 0));
  PolyanyaSearch search{Polyanya(space)};
  EXPECT_EQ(search.find({0.5, 0.5}, {11.5, 11.5}), SearchStatus::found);
  EXPECT_EQ(search.expanded(), 1u);
  EXPECT_EQ(search.find({0.5, 0.5}, {11.5, 11.5}, {.expansions = 3}), SearchStatus::stopped);
  EXPECT_EQ(search.expanded(), 3u);
}

RC_GTEST_PROP(SleevesProperty, HaveTheShortestPathsAmongWalls, ()) {
  const SmallWorld world = any_world({.side = 7, .walls = 6, .solids = 0});
  std::optional<FreeSpace> space;
  try {
    space = world.space();
  } catch (const InputError&) {
    return;  // walls that meet more sharply than doubles can say
  }
  PolyanyaSearch trees{Polyanya(*space)}, portals{Polyanya(*space, navmesh(*space))};
  for (int n = 0; n < 30; ++n) {
    const int fine = any(0, 1) == 0 ? 1 : 4;
    const auto coordinate = [&] { return static_cast<double>(any(0, 7 * fine)) / fine; };
    const double x = coordinate(), y = coordinate(), u = coordinate(), v = coordinate();
    const SearchStatus expected = portals.find({x, y}, {u, v});
    RC_ASSERT(trees.find({x, y}, {u, v}) == expected);
    if (expected == SearchStatus::found && trees.result().path.length != portals.result().path.length)
      RC_FAIL(fmt::format("{} from {} to {}", show(world), show(Point{x, y}), show(Point{u, v})));
  }
}

}  // namespace
}  // namespace taut
