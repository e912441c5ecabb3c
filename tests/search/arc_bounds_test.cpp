#include <taut/search/arc_bounds.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/arc_search.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

/// No path at radii between is shorter than the bound; where the smallest disc finds none, no larger one does.
void bounds_paths(const World& world, double least, double most, const std::vector<std::array<Point, 2>>& ends) {
  const AllRadii all{FreeSpace(world)};
  ArcBounds bounds(all.at_radius(least), most);
  for (const auto& [s, g] : ends) {
    RC_LOG(fmt::format("s {} g {} from {} to {}\n", test::show(s), test::show(g), least, most));
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      const double r = share == 1 ? most : least + share * (most - least);
      const ArcSearchResult found = arc_search(all, r, s, g);
      const double bound = bounds.length_at_least(r, s, g);
      if (found.status == DiscStatus::found) RC_ASSERT(bound <= found.path.length.hi);
      if (share == 0 && found.status == DiscStatus::found) RC_ASSERT(bound >= found.path.length.lo * (1 - 1e-9));
      if (share == 0 && found.status != DiscStatus::found) RC_ASSERT(std::isinf(bound));
    }
  }
}

RC_GTEST_PROP(ArcBounds, LieBelowThePathsOfLargerDiscsInMessyWorlds, ()) {
  const test::SmallWorld small =
      test::any_world({.side = 6, .walls = 7, .solids = 2, .straight = test::any(0, 1) == 1});
  const Boundary boundary = std::array{Boundary::walled, Boundary::limit, Boundary::open}[test::any(0, 2)];
  RC_LOG(test::show(small) + fmt::format(" boundary {}\n", int(boundary)));
  std::vector<std::array<Point, 2>> ends;
  for (int n = 0; n < 3; ++n) ends.push_back({test::any_fine_point(6), test::any_fine_point(6)});
  const double least = test::any(1, 50) / 100.0;
  bounds_paths(small.bounded(boundary), least, least + test::any(1, 60) / 100.0, ends);
}

// Gates of a maze of unit cells close at 0.5, those past corners at other radii.
RC_GTEST_PROP(ArcBounds, LieBelowThePathsOfLargerDiscsInMazes, ()) {
  const int width = test::any(2, 6), height = test::any(2, 6), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(width, height, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  RC_LOG(fmt::format("{} x {} seed {}\n", width, height, seed));
  std::vector<std::array<Point, 2>> ends;
  for (int n = 0; n < 3; ++n) {
    const int x = test::any(0, width - 1), y = test::any(0, height - 1), u = test::any(0, width - 1);
    const int v = test::any(0, height - 1);
    ends.push_back({Point{x + 0.5, y + 0.5}, Point{u + 0.5, v + 0.5}});
  }
  bounds_paths(world_of(maze), test::any(1, 48) / 100.0, 0.5, ends);
}

// The way past the near post turns much and the door beside it closes at 0.2: lines drawn through lengths at two lower
// radii would lie above the length at a third.
TEST(ArcBounds, HoldWhereAWayClosesAndWhereLinesThroughLengthsDoNot) {
  const World world = read_world("boundary 0 0 10 6\n5 0 5 0.8\n5 1.2 5 2.6\n5 3.8 5 6\n", {});
  const AllRadii all{FreeSpace(world)};
  const Point s{1, 1}, g{9, 1};
  const auto length = [&](double r) { return arc_search(all, r, s, g).path.value(); };
  const double before = length(0.2), after = length(0.21), later = length(0.3);
  EXPECT_GT(before + (after - before) / 0.01 * 0.1, later + 1);
  ArcBounds bounds(all.at_radius(0.21), 0.6);
  EXPECT_LE(bounds.length_at_least(0.3, s, g), later);
  EXPECT_GT(bounds.length_at_least(0.3, s, g), later - 0.01);
}

}  // namespace
}  // namespace taut
