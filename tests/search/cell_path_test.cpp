// Paths on cells against paths on triangles: two roads to one answer.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include <taut/geometry/cell_plan.h>
#include <taut/geometry/occupancy_world.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/random_world.h"

namespace {

using namespace taut;
using namespace taut::test;

/// Axis-parallel walls and boxes on uneven lines.
World any_straight_world(int side) {
  SmallWorld drawn = any_world({.side = side, .walls = 4 * side, .solids = 0, .straight = true});
  WorldParts parts;
  const bool uneven = any(0, 1) == 0;
  const auto place = [&](Point p) { return uneven ? Point{p.x * 0.7, p.y + (p.y > 2 ? 0.1 : 0)} : p; };
  const auto ring = [&](Ring given) {
    for (Point& p : given) p = place(p);
    return given;
  };
  parts.areas = {{{ring(drawn.area), {}}, 0}};
  if (any(0, 1)) parts.boundary = Boundary::walled;
  for (const Segment& wall : drawn.walls) parts.walls.push_back({place(wall.a), place(wall.b), 0, 0});
  for (int n = any(0, 4); n > 0; --n) {
    const Point a = any_lattice_point(side - 1);
    parts.solids.push_back({{ring(box_ring(a.x, a.y, a.x + any(1, 2), a.y + any(1, 2))), {}}, 0});
  }
  return World(std::move(parts));
}

World any_grid_map(std::uint32_t side) {
  OccupancyGrid grid{side, side, {}};
  const int share = any(1, 6);
  for (std::uint32_t i = 0; i < side * side; ++i) grid.blocked.push_back(any(0, 9) < share ? 1 : 0);
  return world_of(std::move(grid));
}

/// As segments, and the corners of solids.
std::string shown(const World& world) {
  std::string text;
  for (const Wall& wall : world.walls()) text += show(wall.a) + "-" + show(wall.b) + " ";
  for (const Area& solid : world.solids())
    for (const Point p : solid.polygon.outer) text += show(p);
  return text;
}

/// On lines and between them, now and then beyond.
Point any_place_in(const Box& box, double step) {
  const auto along = [&](double from, double to) {
    return from + step * any(-1, static_cast<int>((to - from) / step) + 1);
  };
  const double x = along(box.min.x, box.max.x), y = along(box.min.y, box.max.y);
  return {x, y};
}

void agree(const World& world, double step) {
  const FreeSpace cells(world), triangles(world);
  RC_ASSERT(cells.cells() != nullptr);
  PolyanyaSearch search{Polyanya(triangles)};
  for (int n = 0; n < 16; ++n) {
    const Point from = any_place_in(world.box(), step), to = any_place_in(world.box(), step),
                aside = any_place_in(world.box(), step);
    const std::string what = show(from) + " to " + show(to) + " towards " + show(aside) + " in " + shown(world);
    const auto is_free = [&](Point p) { return triangles.locate(p).kind != Location::Kind::outside; };
    if (cells.holds(from) != is_free(from)) RC_FAIL(what + ": holds");
    if (cells.sees(from, to) != triangles.sees(from, to)) RC_FAIL(what + ": sees");
    if (cells.sees(from, to, aside) != triangles.sees(from, to, aside)) RC_FAIL(what + ": sees towards");
    if (!is_free(from) || !is_free(to)) continue;
    PolyanyaSearch between{Polyanya::between(cells, from, {to, {}})};
    search.find(from, to);
    between.find(from, to);
    const GraphSearchResult expected = search.result(), found = between.result();
    if (found.status != expected.status) RC_FAIL(what + ": one finds a path, the other none");
    if (found.status != SearchStatus::found) continue;
    if (found.path.length != expected.path.length)
      RC_FAIL(what + fmt::format(": {} instead of {}", found.path.length.value(), expected.path.length.value()));
    const Verdict near = verify_along(found.path, cells, from, {to, {}}),
                  all = verify(found.path, triangles, from, {to, {}});
    if (!near.valid || !all.valid) RC_FAIL(what + ": " + near.reason + all.reason);
    if (near.clearance != all.clearance) RC_FAIL(what + ": clearance");
  }
  RC_ASSERT(!cells.is_triangulated());
}

RC_GTEST_PROP(CellPath, IsAsLongAsOneAmongTriangles, ()) { agree(any_straight_world(any(2, 7)), 0.25); }

RC_GTEST_PROP(CellPath, IsAsLongAsOneAmongTrianglesOnAGridMap, ()) { agree(any_grid_map(8), 0.5); }

RC_GTEST_PROP(CellPath, EntersARoomWhereOneAmongTrianglesDoes, ()) {
  const World world = any_straight_world(6);
  const FreeSpace cells(world), triangles(world);
  PolyanyaSearch search{Polyanya(triangles)};
  for (int n = 0; n < 8; ++n) {
    const Point from = any_place_in(world.box(), 0.25), corner = any_place_in(world.box(), 0.5);
    if (!cells.holds(from)) continue;
    const Goal to{std::nullopt, {{corner, {corner.x + 1, corner.y + 0.5}}}};
    PolyanyaSearch between{Polyanya::between(cells, from, to)};
    search.find(from, to);
    between.find(from, to);
    const GraphSearchResult expected = search.result(), found = between.result();
    const std::string what = show(from) + " to the room at " + show(corner) + " in " + shown(world);
    if (found.status != expected.status) RC_FAIL(what + ": one finds a path, the other none");
    if (found.path.length != expected.path.length)
      RC_FAIL(what + fmt::format(": {} instead of {}", found.path.length.value(), expected.path.length.value()));
  }
  RC_ASSERT(!cells.is_triangulated());
}

/// A path that nobody looked for: refused or not, both checks agree.
RC_GTEST_PROP(CellPath, IsRefusedWhereTheCheckAgainstAllConstraintsRefusesIt, ()) {
  const World world = any_straight_world(5);
  const FreeSpace cells(world), triangles(world);
  for (int n = 0; n < 10; ++n) {
    Path path;
    for (int k = any(1, 4); k >= 0; --k) path.points.push_back(any_place_in(world.box(), 0.5));
    path.length = Length(path.points);
    const Goal to{path.points.back(), {}};
    const Verdict near = verify_along(path, cells, path.points.front(), to),
                  all = verify(path, triangles, path.points.front(), to);
    RC_ASSERT(near.valid == all.valid);
    RC_ASSERT(near.reason == all.reason);
    RC_ASSERT(near.clearance == all.clearance);
  }
}

TEST(CellPath, TurnsAroundTheFreeEndOfAWall) {
  WorldParts parts;
  parts.areas = {{{box_ring(0, 0, 4, 4), {}}, 0}};
  parts.walls = {{{2, 0}, {2, 3}, 0, 0}};
  const FreeSpace space{World(parts)};
  const auto path = shortest_path(Polyanya::between(space, {1, 1}, {Point{3, 1}, {}}), {1, 1}, {Point{3, 1}, {}});
  EXPECT_EQ(path.path.points, (std::vector<Point>{{1, 1}, {2, 3}, {3, 1}}));
  EXPECT_FALSE(space.is_triangulated());
}

TEST(CellPath, SlipsThroughNoPointWhereTwoBlocksTouch) {
  const FreeSpace space(world_of(OccupancyGrid{2, 2, {0, 1, 1, 0}}));
  const Goal to{Point{1.5, 1.5}, {}};
  EXPECT_EQ(shortest_path(Polyanya::between(space, {0.5, 0.5}, to), {0.5, 0.5}, to).status, SearchStatus::none);
  const std::vector<Point> through{{0.5, 0.5}, {1.5, 1.5}};
  EXPECT_FALSE(verify_along({through, Length(through)}, space, {0.5, 0.5}, to).valid);
}

TEST(CellPath, EntersNoRoomOnTheOtherSideOfAJointOfWalls) {
  WorldParts parts;
  parts.areas = {{{box_ring(0, 0, 4, 6), {}}, 0}};
  parts.walls = {{{0, 2}, {3, 2}, 0, 0}, {{1, 1}, {1, 2}, 0, 0}, {{3, 2}, {3, 3}, 0, 0}};
  parts.solids = {{{box_ring(3, 3, 4, 4), {}}, 0}};
  const FreeSpace space{World(parts)};
  const Goal to{std::nullopt, {{{2, 3.5}, {4, 4}}}};
  EXPECT_EQ(shortest_path(Polyanya::between(space, {3.5, 2}, to), {3.5, 2}, to).status, SearchStatus::none);
  EXPECT_EQ(shortest_path(VisibilityGraph(space), {3.5, 2}, to).status, SearchStatus::none);
}

TEST(CellPath, HasTheClearanceOfThePieceThatIsNearest) {
  OccupancyGrid grid{300, 300, std::vector<std::uint8_t>(300 * 300, 0)};
  grid.blocked[300 * 150 + 150] = 1;
  const FreeSpace space(world_of(std::move(grid)));
  const std::vector<Point> points{{100, 100}, {100, 200}};
  const Path path{points, Length(points)};
  EXPECT_EQ(verify_along(path, space, {100, 100}, {Point{100, 200}, {}}).clearance, 50);
  EXPECT_FALSE(space.is_triangulated());
}

}  // namespace
