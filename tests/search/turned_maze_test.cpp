// Mazes as surveys give them: turned by some angle, walls with a thickness, coordinates in the millions. Doubles find
// some points of their diagrams badly or not at all; the diagram has to agree with the gates, which need none of them.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/search/clearance_search.h>
#include <taut/search/disc_passage.h>

namespace taut {
namespace {

/// Turned around the origin, then moved to where a survey's zone may have it.
class Survey {
 public:
  explicit Survey(double angle) : cos_(std::cos(angle)), sin_(std::sin(angle)) {}

  Point operator()(Point p) const { return {500000.3 + cos_ * p.x - sin_ * p.y, 5400000.7 + sin_ * p.x + cos_ * p.y}; }

 private:
  double cos_, sin_;
};

struct TurnedMaze {
  World world;
  Point from, to;
};

TurnedMaze turned_maze(int cells, std::uint64_t seed) {
  const Survey at(0.0173 + 0.0131 * static_cast<double>(seed));
  auto grid = std::make_shared<GridMaze>(generate_backtracker(cells, cells, seed));
  open_walls(*grid, 0.2, seed);
  const World straight = world_of(std::move(grid));
  WorldParts parts;
  parts.areas = straight.areas();
  parts.boundary = Boundary::walled;
  for (Point& p : parts.areas[0].polygon.outer) p = at(p);
  for (const Wall& wall : straight.walls()) parts.walls.push_back({at(wall.a), at(wall.b), 0.1});
  const double far = cells - 0.5;
  return {World(std::move(parts)), at({0.5, 0.5}), at({far, far})};
}

class TurnedMazes : public testing::TestWithParam<std::uint64_t> {};

TEST_P(TurnedMazes, HaveTheWidestWayThatTheGatesHave) {
  const TurnedMaze maze = turned_maze(static_cast<int>(4 + GetParam() % 9), GetParam());
  const FreeSpace space(maze.world);
  const VoronoiRoadmap diagram(space);
  EXPECT_LT(diagram.max_error(), 1e-8);  // some units in the last place of a northing
  const auto widest = ClearanceSearch(diagram, maze.from, maze.to).widest();
  const auto gates = widest_passage(space, maze.from, maze.to);
  ASSERT_TRUE(widest && gates);
  // Corners of walls are decimals of 15 digits: at survey coordinates that is 1e-9.
  EXPECT_NEAR(widest->pinch.clearance, gates->radius, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(AtSurveyCoordinates, TurnedMazes, testing::Range<std::uint64_t>(1, 121));

}  // namespace
}  // namespace taut
