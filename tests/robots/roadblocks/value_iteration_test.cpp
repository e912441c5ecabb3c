// Value iteration against Dijkstra on the same graph.
#include <gtest/gtest.h>

#include <numbers>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/robots/roadblocks/value_planner.h>

#include "support/car_drawing.h"

namespace taut::roadblocks {
namespace {

using test::map_of;

/// From the goal states backwards, over edges that were turned round one by one.
std::vector<double> dijkstra(const ValueGrid& grid) {
  std::vector<std::vector<std::pair<std::size_t, double>>> into(grid.size());
  std::vector<double> least(grid.size(), ValueGrid::kNever);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t s = 0; s < grid.size(); ++s) {
    for (const Action action : kActions)
      if (grid.cost(s, action) != ValueGrid::kNever) into[grid.after(s, action)].emplace_back(s, grid.cost(s, action));
    if (grid.is_goal(s)) open.emplace(least[s] = 0, s);
  }
  while (!open.empty()) {
    const auto [by, s] = open.top();
    open.pop();
    if (by > least[s]) continue;
    for (const auto& [from, cost] : into[s])
      if (cost + by < least[from]) open.emplace(least[from] = cost + by, from);
  }
  return least;
}

RoadblockMap clutter_map(taut::Draws& draws) {
  std::vector<std::string> rows(26, "#" + std::string(30, '.') + "#");
  rows.front() = rows.back() = std::string(32, '#');
  for (int i = 0; i < 14; ++i) {
    const std::uint32_t x = draws.below(30);
    const std::uint32_t y = draws.below(24);
    rows[y + 1][x + 1] = '#';
  }
  for (std::size_t y = 2; y < 7; ++y)
    for (std::size_t x = 2; x < 7; ++x) rows[y][x] = '.';
  rows[4][4] = 'S';
  rows[20][26] = 'G';
  return map_of(rows);
}

TEST(ValueIteration, AgreesToTheBitWithDijkstraOnItsOwnDiscretisation) {
  taut::Draws draws(3);
  for (int i = 0; i < 12; ++i) {
    const RoadblockMap map = clutter_map(draws);
    const WallReading reading = i % 3 == 0 ? WallReading::squares : WallReading::points;
    const ValueGrid grid(map.course, 0, reading, 1 + i % 2, {i % 4 == 0 ? 1.0 : 9.0, i % 4 == 1});
    const std::vector<double> expected = dijkstra(grid);
    EXPECT_EQ(value_iteration(grid, Sweeping::in_place).of, expected) << i;
    EXPECT_EQ(value_iteration(grid, Sweeping::at_once).of, expected) << i;
    std::size_t valued = 0;
    for (const double value : expected) valued += value > 0 && value != ValueGrid::kNever;
    EXPECT_GT(valued, 100U);
  }
}

TEST(ValueIteration, ChargesMovesTurnsAndWallsAround) {
  std::vector<std::string> rows(15, std::string(24, '.'));
  rows[7][3] = 'S';
  rows[7][20] = 'G';
  rows[3][10] = '#';
  const RoadblockMap map = map_of(rows);
  const ValueGrid grid(map.course, 0, WallReading::points);
  const auto ahead = [&](int i, int j, int heading) { return grid.cost(grid.index(i, j, heading), Action::straight); };
  EXPECT_EQ(ahead(6, 7, 0), 1);
  EXPECT_EQ(ahead(6, 7, 1), std::numbers::sqrt2);
  EXPECT_EQ(ahead(8, 3, 1), std::numbers::sqrt2 + 1);  // past the wall, which is then at a corner, off the car's flank
  EXPECT_EQ(ahead(10, 2, 0), ValueGrid::kNever);       // the wall's point is on the flank
  EXPECT_EQ(grid.cost(grid.index(6, 7, 0), Action::turn_plus), 9);
  EXPECT_EQ(grid.after(grid.index(6, 7, 0), Action::turn_minus), grid.index(6, 7, 7));
  EXPECT_EQ(grid.cost(grid.index(6, 7, 0), Action::back), ValueGrid::kNever);
}

TEST(ValuePlanner, DrivesThroughALaneThreeWideOnHalfCells) {
  std::vector<std::string> rows(18, "#" + std::string(48, '.') + "#");
  rows.front() = rows.back() = std::string(50, '#');
  for (std::size_t y = 1; y < 17; ++y)
    if (y != 8 && y != 9) rows[y].replace(15, 20, 20, '#');
  rows[8][5] = 'S';
  rows[8][44] = 'G';
  const RoadblockMap map = map_of(rows);
  ValuePlanner planner(map.course, WallReading::points);
  ASSERT_TRUE(planner.plan({map.course.start.x, map.course.start.y, 0}, 0).plan);
  EXPECT_EQ(planner.grid()->per_unit(), 2);
  EXPECT_EQ(dijkstra(*planner.grid()), planner.values()->of);
}

}  // namespace
}  // namespace taut::roadblocks
