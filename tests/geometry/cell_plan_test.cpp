#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/cell_plan.h>
#include <taut/geometry/contact.h>
#include <taut/geometry/occupancy_world.h>

#include "support/random_world.h"

namespace {

using namespace taut;
using namespace taut::test;

World walls_in(const Ring& area, std::vector<Wall> walls) {
  WorldParts parts;
  parts.areas = {{{area, {}}, 0}};
  parts.walls = std::move(walls);
  return World(parts);
}

TEST(CellPlan, HasALineForEachCoordinate) {
  const auto plan = CellPlan::of(walls_in(box_ring(0, 0, 10, 4), {{{0.5, 1}, {2.5, 1}, 0, 0}}));
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->columns(), 3U);
  EXPECT_EQ(plan->rows(), 2U);
  EXPECT_EQ(plan->x(1), 0.5);
  EXPECT_TRUE(plan->is_open_above({0, 0}));
  EXPECT_FALSE(plan->is_open_above({1, 0}));
  EXPECT_TRUE(plan->is_open_right({1, 1}));
  EXPECT_FALSE(plan->is_free({3, 0}));
}

TEST(CellPlan, IsNothingWhereAWallIsSlopedOrThick) {
  EXPECT_FALSE(CellPlan::of(walls_in(box_ring(0, 0, 4, 4), {{{1, 1}, {2, 3}, 0, 0}})));
  EXPECT_FALSE(CellPlan::of(walls_in(box_ring(0, 0, 4, 4), {{{1, 1}, {1, 3}, 0.5, 0}})));
}

TEST(CellPlan, IsNothingWhereThereWouldBeFarMoreCellsThanWalls) {
  std::vector<Wall> walls;
  for (int i = 1; i < 200; ++i) walls.push_back({{i + 0.5, i + 0.25}, {i + 0.75, i + 0.25}, 0, 0});
  EXPECT_FALSE(CellPlan::of(walls_in(box_ring(0, 0, 300, 300), walls)));
}

TEST(CellPlan, TakesWhatBlocksShareForSolidAndAHoleForFree) {
  WorldParts parts;
  parts.areas = {{{box_ring(0, 0, 6, 6), {}}, 0}};
  parts.solids = {{{box_ring(1, 1, 3, 3), {}}, 0}, {{box_ring(2, 2, 5, 5), {box_ring(3, 3, 4, 4)}}, 0}};
  const auto plan = CellPlan::of(World(parts));
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->around({2.5, 2.5}).free, 0U);
  EXPECT_EQ(plan->around({3.5, 3.5}).free, 15U);
  EXPECT_EQ(plan->around({3, 3}).free, 1U);
}

TEST(CellPlan, OfAGridMapIsThatOfItsOutlines) {
  const World map = world_of(OccupancyGrid{70, 3, [] {
                                             std::vector<std::uint8_t> cells(210, 0);
                                             for (std::size_t i = 0; i < cells.size(); i += 7) cells[i] = 1;
                                             return cells;
                                           }()});
  ASSERT_NE(map.raster(), nullptr);
  const World outlined(map.parts());
  EXPECT_EQ(outlined.raster(), nullptr);
  const auto one = CellPlan::of(map), other = CellPlan::of(outlined);
  ASSERT_TRUE(one && other);
  for (double x = -0.5; x <= 70.5; x += 0.5)
    for (double y = -0.5; y <= 3.5; y += 0.5) EXPECT_EQ(one->around({x, y}).free, other->around({x, y}).free);
}

/// What the pieces along a leg are good for: whatever of all constraints meets the leg is covered by them.
RC_GTEST_PROP(CellPlanProperty, FindsAllPiecesThatALegMeets, ()) {
  const SmallWorld drawn = any_world({.side = 6, .walls = 20, .solids = 0, .straight = true});
  WorldParts parts;
  parts.areas = {{{drawn.area, {}}, 0}};
  for (const Segment& wall : drawn.walls) parts.walls.push_back({wall.a, wall.b, 0, 0});
  const FreeSpace space{World(parts)};
  RC_ASSERT(space.cells() != nullptr);
  const Segment leg{any_fine_point(6), any(0, 1) ? any_lattice_point(6) : any_fine_point(6)};
  std::vector<Constraint> near;
  space.cells()->append_along(leg, near);
  const auto count = [&](const auto& pieces, Contact kind) {
    return std::count_if(pieces.begin(), pieces.end(), [&](const Constraint& c) { return contact(leg, c) == kind; });
  };
  RC_ASSERT((count(near, Contact::cross) > 0) == (count(space.constraints(), Contact::cross) > 0));
  RC_ASSERT((count(near, Contact::touch) > 0) == (count(space.constraints(), Contact::touch) > 0));
}

}  // namespace
