#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/free_space.h>
#include <taut/geometry/occupancy_world.h>

#include "support/random_world.h"

namespace taut {
namespace {

OccupancyGrid grid_of(const std::vector<std::string>& rows) {
  OccupancyGrid grid;
  grid.width = static_cast<std::uint32_t>(rows[0].size());
  grid.height = static_cast<std::uint32_t>(rows.size());
  for (const std::string& row : rows)
    for (const char c : row) grid.blocked.push_back(c == '#');
  return grid;
}

double area_of(const FreeSpace& space) {
  double area = 0;
  const Triangulation& tri = space.triangulation();
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t) {
    if (!tri.free[t]) continue;
    const Point a = tri.points[tri.triangles[t][0]], b = tri.points[tri.triangles[t][1]],
                c = tri.points[tri.triangles[t][2]];
    area += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  return area;
}

TEST(OccupancyWorld, TracesAWholePieceAsOnePolygonWithHoles) {
  const World world = world_of(grid_of({".....", ".###.", ".#.#.", ".###.", "....."}));
  ASSERT_EQ(world.solids().size(), 1U);
  EXPECT_EQ(world.solids()[0].polygon.outer.size(), 4U);
  ASSERT_EQ(world.solids()[0].polygon.holes.size(), 1U);
  EXPECT_EQ(FreeSpace(world).component_count(), 2U);
}

TEST(OccupancyWorld, LeavesNoWayBetweenCellsThatTouchAtACorner) {
  EXPECT_EQ(FreeSpace(world_of(grid_of({".#", "#."}))).component_count(), 2U);
  EXPECT_EQ(FreeSpace(world_of(grid_of({"#.", ".#"}))).component_count(), 2U);
}

TEST(OccupancyWorld, CutsAnOutlineThatComesToItsOwnCornerAgain) {
  const World world = world_of(grid_of({"###.", "#.#.", "##..", "...."}));  // the hole touches the outside
  ASSERT_EQ(world.solids().size(), 1U);
  EXPECT_EQ(world.solids()[0].polygon.holes.size(), 1U);
  EXPECT_EQ(FreeSpace(world).component_count(), 2U);
  const World ring = world_of(grid_of({"##..", "#.#.", "###.", "...."}));
  EXPECT_EQ(FreeSpace(ring).component_count(), 2U);
}

TEST(OccupancyWorld, HasWallsAroundIt) {
  const FreeSpace space(world_of(grid_of({"..", ".."})));
  EXPECT_EQ(space.component_count(), 1U);
  EXPECT_EQ(space.locate({2.5, 1}).kind, Location::Kind::outside);
  EXPECT_EQ(FreeSpace(world_of(grid_of({"##", "##"}))).component_count(), 0U);
}

/// The pieces of free cells that hang together by sides.
std::uint32_t pieces(const OccupancyGrid& grid) {
  std::vector<bool> seen(grid.blocked.size(), false);
  std::uint32_t count = 0;
  std::vector<std::pair<int, int>> open;
  for (int y = 0; y < static_cast<int>(grid.height); ++y)
    for (int x = 0; x < static_cast<int>(grid.width); ++x) {
      if (!grid.free(x, y) || seen[static_cast<std::size_t>(y) * grid.width + static_cast<std::size_t>(x)]) continue;
      ++count;
      open.push_back({x, y});
      while (!open.empty()) {
        const auto [u, v] = open.back();
        open.pop_back();
        if (!grid.free(u, v)) continue;
        const std::size_t cell = static_cast<std::size_t>(v) * grid.width + static_cast<std::size_t>(u);
        if (seen[cell]) continue;
        seen[cell] = true;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) open.push_back({u + dx, v + dy});
      }
    }
  return count;
}

RC_GTEST_PROP(OccupancyWorld, IsFreeWhereTheCellsAre, ()) {
  OccupancyGrid grid;
  grid.width = static_cast<std::uint32_t>(test::any(1, 12));
  grid.height = static_cast<std::uint32_t>(test::any(1, 12));
  const int share = test::any(1, 9);
  double area = 0;
  for (std::size_t i = 0; i < std::size_t{grid.width} * grid.height; ++i) {
    grid.blocked.push_back(test::any(0, 9) < share);
    area += !grid.blocked.back();
  }
  const FreeSpace space(world_of(grid));
  RC_ASSERT(area_of(space) == area);
  RC_ASSERT(space.component_count() == pieces(grid));
  for (std::uint32_t y = 0; y < grid.height; ++y)
    for (std::uint32_t x = 0; x < grid.width; ++x)
      RC_ASSERT((space.locate({x + 0.5, y + 0.5}).kind != Location::Kind::outside) == grid.free(x, y));
}

}  // namespace
}  // namespace taut
