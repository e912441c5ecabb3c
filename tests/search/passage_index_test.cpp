#include <taut/search/passage_index.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/roadmaps/exact/exact_gates.h>

#include "support/passage_opinions.h"
#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;
using Limit = WidestPassage::Limit;

/// 10 x 10, walled in.
FreeSpace room(const std::vector<Segment>& walls) {
  return FreeSpace(SmallWorld{.walls = walls, .solids = {}}.bounded(Boundary::walled));
}

void expect_as_widest_passage(const PassageIndex& index, Point s, Point g) {
  const auto ours = index.widest(s, g);
  const auto theirs = widest_passage(index.gates(), s, g);
  ASSERT_EQ(ours.has_value(), theirs.has_value());
  if (!ours) return;
  EXPECT_EQ(ours->limit, theirs->limit);
  EXPECT_EQ(ours->radius, theirs->radius);
  EXPECT_EQ(ours->gate, theirs->gate);
  EXPECT_EQ(ours->constraint, theirs->constraint);
}

TEST(PassageIndex, NamesTheDoorThatEveryDiscHasToPass) {
  const PassageIndex index(room({{{0, 5}, {4, 5}}, {{6, 5}, {10, 5}}}));
  const auto widest = index.widest(Point{5, 2}, {5, 8});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->limit, Limit::gate);
  EXPECT_EQ(widest->radius, 1);
  EXPECT_EQ(index.gates().name(widest->gate), "2 between (4, 5) and (6, 5)");
  EXPECT_EQ(index.passes(Point{5, 2}, {5, 8}, 1), DiscStatus::found);
  EXPECT_EQ(index.passes(Point{5, 2}, {5, 8}, std::nextafter(1, 2)), DiscStatus::none);
  EXPECT_EQ(index.passes(Point{5, 0.5}, {5, 8}, 1), DiscStatus::start_blocked);
}

TEST(PassageIndex, TakesTheWiderOfTwoDoors) {
  const PassageIndex index(room({{{0, 5}, {4, 5}}, {{5, 5}, {7, 5}}, {{9, 5}, {10, 5}}}));
  const auto widest = index.widest(Point{4.5, 2.5}, {4.5, 7.5});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->radius, 1);
  EXPECT_EQ(index.gates().name(widest->gate), "2 between (7, 5) and (9, 5)");
}

TEST(PassageIndex, HasNoWayThroughAWall) {
  const PassageIndex index(room({{{0, 5}, {10, 5}}}));
  EXPECT_FALSE(index.widest(Point{5, 2}, {5, 8}));
  EXPECT_EQ(index.passes(Point{5, 2}, {5, 8}, 0.1), DiscStatus::none);
}

TEST(PassageIndex, LetsADiscStickOutOfAnOpening) {
  // The right side is bare: between the wall's end and the opening the centre has 1 to spare.
  const SmallWorld world{.walls = {{{0, 0}, {10, 0}}, {{0, 10}, {10, 10}}, {{0, 0}, {0, 10}}, {{0, 5}, {9, 5}}},
                         .solids = {}};
  const PassageIndex index(world.space());
  const auto widest = index.widest(Point{7, 2.5}, {7, 7.5});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->radius, 1);
  EXPECT_TRUE(index.gates().gates()[widest->gate].to_opening);
  expect_as_widest_passage(index, {10, 2.5}, {10, 7.5});  // on the opening
}

TEST(PassageIndex, WithoutWallsHasRoomForAnyDisc) {
  const PassageIndex index(FreeSpace(SmallWorld{}.bounded(Boundary::open)));
  const auto widest = index.widest(Point{1, 1}, {9, 9});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->limit, Limit::none);
  EXPECT_EQ(index.passes(Point{1, 1}, {9, 9}, 100), DiscStatus::found);
}

TEST(PassageIndex, FindsPointsInALargeFaceThatHasNoGates) {
  std::vector<Segment> ring;
  for (int i = 0; i < 256; ++i) {
    const auto at = [](int k) {
      return Point{5 + 4 * std::cos(2 * M_PI * k / 256), 5 + 4 * std::sin(2 * M_PI * k / 256)};
    };
    ring.push_back({at(i), at((i + 1) % 256)});
  }
  const PassageIndex index(room(ring));
  expect_as_widest_passage(index, {5, 5}, {4, 7.5});
  expect_as_widest_passage(index, {5, 5}, {0.5, 0.5});
}

/// Worlds a run; where TAUT_PASSAGE_WORLDS is set, that many.
int world_count() {
  const char* wanted = std::getenv("TAUT_PASSAGE_WORLDS");
  return wanted != nullptr ? std::atoi(wanted) : 1;
}

SmallWorld any_small_world() {
  return test::any_world({.side = 6, .walls = 8, .solids = 2, .straight = test::any(0, 1) == 1});
}

void agree(const PassageIndex& index, Point s, Point g) {
  const auto ours = index.widest(s, g);
  const auto theirs = widest_passage(index.gates(), s, g);
  RC_ASSERT(ours.has_value() == theirs.has_value());
  double r = test::any(1, 70) / 100.0;
  if (ours) {
    RC_ASSERT(ours->limit == theirs->limit);
    RC_ASSERT(ours->radius == theirs->radius);
    RC_ASSERT(ours->gate == theirs->gate);
    RC_ASSERT(ours->constraint == theirs->constraint);
    if (ours->radius > 0 && std::isfinite(ours->radius) && test::any(0, 1))
      r = std::array{ours->radius, std::nextafter(ours->radius, 9.0)}[test::any(0, 1)];
  }
  RC_ASSERT(index.passes(s, g, r) == disc_passage(index.gates(), s, g, r).status);
}

RC_GTEST_PROP(PassageIndex, AnswersAsTheChainsOfGatesDo, ()) {
  for (int n = world_count(); n > 0; --n) {
    const SmallWorld small = any_small_world();
    const int boundary = test::any(0, 2);
    RC_LOG(test::show(small) + fmt::format(" boundary {}\n", boundary));
    const PassageIndex index(
        FreeSpace(small.bounded(std::array{Boundary::walled, Boundary::limit, Boundary::open}[boundary])));
    for (int k = 0; k < 8; ++k) {
      const auto end = [&] { return test::any(0, 2) ? test::any_fine_point(6) : test::any_lattice_point(6); };
      const Point s = end(), g = end();
      RC_LOG(fmt::format(" s {} g {}\n", test::show(s), test::show(g)));
      agree(index, s, g);
    }
  }
}

RC_GTEST_PROP(PassageIndex, AnswersAsTheChainsOfGatesDoInOpenedMazes, ()) {
  const int width = test::any(2, 7), height = test::any(2, 7), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(width, height, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  const World world = test::any(0, 1) ? world_of(maze) : world_of(maze).with_wall_thickness(0.25);
  const PassageIndex index{FreeSpace(world)};
  for (int k = 0; k < 8; ++k)
    agree(index, {test::any(0, 8 * width) / 8.0, test::any(0, 8 * height) / 8.0},
          {test::any(0, 97 * width) / 97.0, test::any(0, 97 * height) / 97.0});
}

}  // namespace
}  // namespace taut
