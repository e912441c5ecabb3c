// An index: its answers where they can be checked by eye, and on mazes; what it costs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/maze_generator.h>
#include <taut/search/detail/index_builder.h>
#include <taut/search/index.h>
#include <taut/search/polyanya.h>
#include <taut/search/verify.h>

#include "support/random_world.h"
#include "support/small_world.h"
#include "support/turned.h"

namespace taut {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

World opened_maze(int cells, double opened) {
  auto grid = std::make_shared<GridMaze>(generate_backtracker(cells, cells, 5));
  open_walls(*grid, opened, 5);
  return world_of(std::move(grid));
}

template <class Turn>
void expect_agreement(const FreeSpace& space, const Index& made, int cells, int count, Turn turn) {
  PolyanyaSearch cones{Polyanya(space)};
  IndexSearch index(made);
  for (int n = 0; n < count; ++n) {
    const auto coordinate = [&](int k) { return (k * 37 + n * 101) % (8 * cells + 1) / 8.0; };
    const Point from = turn({coordinate(1), coordinate(5 + n % 7)}),
                to = turn({coordinate(11), coordinate(17 + n % 3)});
    if (space.locate(from).kind == Location::Kind::outside || space.locate(to).kind == Location::Kind::outside)
      continue;
    ASSERT_EQ(index.find(from, to), cones.find(from, to));
    const Path path{index.points(), Length(index.points())};
    EXPECT_EQ(path.length, Length(cones.points())) << show(from) << " to " << show(to);
    EXPECT_TRUE(verify(path, space, from, {to, {}}).valid) << show(from) << " to " << show(to);
  }
}

Point stay(Point p) { return p; }

TEST(Index, HasTheShortestPathsOfMazesWithLoops) {
  for (const double thickness : {0.0, 0.25}) {
    const FreeSpace space(opened_maze(20, 0.3).with_wall_thickness(thickness));
    expect_agreement(space, Index(space), 20, 400, stay);
  }
}

TEST(Index, HasThemOffEveryLattice) {
  const Turn turn(31.4);
  WorldParts parts = opened_maze(12, 0.3).with_wall_thickness(0.125).parts();
  parts.goal = {};
  const FreeSpace space{World(turn(std::move(parts)))};
  EXPECT_TRUE(space.triangulation().lattice.empty());
  expect_agreement(space, Index(space), 12, 200, [&](Point p) { return turn(p); });
}

TEST(Index, TurnsAroundABlockOnTheShorterSide) {
  // Both ways are equally long; or one is shorter by far less than labels tell apart.
  const double shift = 0x1p-24;
  const SmallWorld even{.solids = {box_ring(4, 3, 6, 7)}}, uneven{.solids = {box_ring(4, 3, 6, 7 - shift)}};
  for (const SmallWorld& world : {even, uneven}) {
    const FreeSpace space = world.space();
    IndexSearch index{Index(space)};
    PolyanyaSearch cones{Polyanya(space)};
    for (const auto& [from, to] : {std::pair(Point{1, 5}, Point{9, 5}), std::pair(Point{9, 5}, Point{1, 5})}) {
      ASSERT_EQ(index.find(from, to), SearchStatus::found);
      cones.find(from, to);
      EXPECT_EQ(Length(index.points()), Length(cones.points()));
    }
  }
  IndexSearch index{Index(uneven.space())};
  index.find({1, 5}, {9, 5});
  EXPECT_THAT(index.points(), ElementsAre(Point{1, 5}, Point{4, 7 - shift}, Point{6, 7 - shift}, Point{9, 5}));
}

TEST(Index, LeavesOutPointsInAStraightLine) {
  const SmallWorld world{.solids = {box_ring(2, 2, 3, 5), box_ring(4, 2, 5, 5), box_ring(6, 2, 7, 5)}};
  IndexSearch index{Index(world.space())};
  index.find({1, 4}, {8, 4});
  EXPECT_THAT(index.points(), ElementsAre(Point{1, 4}, Point{2, 5}, Point{7, 5}, Point{8, 4}));
  index.find({1.7, 4.1}, {1.7, 4.1});
  EXPECT_THAT(index.points(), ElementsAre(Point{1.7, 4.1}));
}

TEST(Index, KnowsThatThereIsNoPath) {
  const SmallWorld world{.walls = {{{5, 0}, {5, 10}}}, .solids = {box_ring(1, 1, 2, 2)}};
  IndexSearch index{Index(world.space())};
  EXPECT_EQ(index.find({3, 5}, {8, 5}), SearchStatus::none);
  EXPECT_TRUE(index.points().empty());
  EXPECT_EQ(index.find({5, 5}, {8, 5}), SearchStatus::found) << "from the wall itself, to its other side";
  EXPECT_EQ(index.find({5, 5}, {0.5, 0.5}), SearchStatus::found);
  EXPECT_THROW(index.find({1.5, 1.5}, {3, 3}), InputError);
  EXPECT_THROW(index.find({3, 3}, {11, 3}), InputError);
}

TEST(Index, HasNothingToDoInAnEmptyRoom) {
  IndexSearch index{Index(SmallWorld{}.space())};
  EXPECT_EQ(index.find({1, 1}, {9, 3}), SearchStatus::found);
  EXPECT_THAT(index.points(), ElementsAre(Point{1, 1}, Point{9, 3}));
}

TEST(Index, StaysBelowTheMemoryItMayHave) {
  const FreeSpace space(opened_maze(20, 0.3));
  const std::size_t needed = Index(space).bytes().size();
  EXPECT_LE(Index(space, needed).bytes().size(), needed);
  EXPECT_THROW(Index(space, 1000), InputError);
}

TEST(Index, HasTheShortestPathsInLittleMemory) {
  for (const double thickness : {0.0, 0.25}) {
    const FreeSpace space(opened_maze(30, 0.3).with_wall_thickness(thickness));
    const std::size_t needed = Index(space).bytes().size();
    const Index small(space, needed * 2 / 3);
    EXPECT_LE(small.bytes().size(), needed * 2 / 3);
    expect_agreement(space, small, 30, 300, stay);
  }
}

TEST(Index, ClimbsFartherThanTheWorldIsWide) {
  // Around all of it from the one side of a wall to the other.
  const SmallWorld world{
      .walls =
          {{{9, 2}, {1, 2}}, {{6, 1}, {1, 1}}, {{8, 3}, {3, 3}}, {{7, 5}, {1, 5}}, {{1, 5}, {1, 1}}, {{3, 3}, {3, 5}}},
      .area = box_ring(0, 0, 9, 9)};
  const FreeSpace space = world.space();
  PolyanyaSearch cones{Polyanya(space)};
  ASSERT_EQ(cones.find({1.25, 2.25}, {1.1, 1.1}), SearchStatus::found);
  for (const std::size_t core : {1, 2, 3, 6}) {
    const auto bytes = std::make_shared<const std::vector<std::byte>>(
        detail::index_bytes(VisibilityGraph(space), 1 << 20, core).value());
    IndexSearch index{Index(space, *bytes, bytes)};
    ASSERT_EQ(index.find({1.25, 2.25}, {1.1, 1.1}), SearchStatus::found) << core;
    EXPECT_EQ(index.points(), cones.points());
  }
}

TEST(Index, HasThemInLittleMemoryOffEveryLattice) {
  const Turn turn(31.4);
  WorldParts parts = opened_maze(12, 0.3).with_wall_thickness(0.125).parts();
  parts.goal = {};
  const FreeSpace space{World(turn(std::move(parts)))};
  const auto bytes =
      std::make_shared<const std::vector<std::byte>>(detail::index_bytes(VisibilityGraph(space), 1 << 24, 40).value());
  expect_agreement(space, Index(space, *bytes, bytes), 12, 200, [&](Point p) { return turn(p); });
}

TEST(Index, IsTheSameFromItsBytes) {
  const FreeSpace space(opened_maze(15, 0.3));
  const Index made(space);
  const auto copy = std::make_shared<std::vector<std::byte>>(made.bytes().begin(), made.bytes().end());
  expect_agreement(space, Index(space, *copy, copy), 15, 100, stay);
  EXPECT_EQ(std::memcmp(Index(space).bytes().data(), copy->data(), copy->size()), 0) << "built twice, it is the same";
}

std::string reason(const FreeSpace& space, const std::vector<std::byte>& bytes) {
  try {
    Index(space, bytes, nullptr);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Index, RefusesBytesThatAreDamagedOrOfAnotherWorld) {
  const FreeSpace space(opened_maze(8, 0.3));
  const std::vector<std::byte> good = detail::index_bytes(VisibilityGraph(space), 1 << 24, 30).value();
  EXPECT_EQ(reason(space, good), "");
  EXPECT_THAT(reason(FreeSpace(opened_maze(8, 0.2)), good), HasSubstr("another triangulation"));
  EXPECT_THAT(reason(space, {}), HasSubstr("cut off"));
  EXPECT_THAT(reason(space, {good.begin(), good.end() - 4}), HasSubstr("cut off"));
  for (std::size_t i = 0; i < good.size(); i += 1 + good.size() / 400) {
    std::vector<std::byte> bad = good;
    bad[i] ^= std::byte{0x10};
    EXPECT_NE(reason(space, bad), "") << i;
  }
}

}  // namespace
}  // namespace taut
