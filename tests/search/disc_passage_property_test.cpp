#include <taut/search/disc_passage.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include <taut/geometry/maze_generator.h>

#include "support/passage_opinions.h"
#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::flooded;
using test::inflated;
using test::separates;
using test::SmallWorld;

/// Both ways to one answer, for one radius that is not within the polygon's excess of a critical one.
void agrees_with_inflation(const World& world, const Gates& gates, Point s, Point g, double r) {
  const DiscPassage passage = disc_passage(gates, s, g, r);
  if (inflated(world, s, g, r) == true) RC_ASSERT(passage.status == DiscStatus::found);
  if (inflated(world, s, g, r / (1 + 1.001 * Footprint::kDiscExcess)) != true)
    RC_ASSERT(passage.status != DiscStatus::found);
  if (passage.status == DiscStatus::none) RC_ASSERT(separates(gates, passage.barrier, s, g));
}

RC_GTEST_PROP(DiscPassage, AgreesWithTheInflatedPolygonInMessyWorlds, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 7, .solids = 2, .straight = test::any(0, 1) == 1});
  const World world = small.bounded(std::array{Boundary::walled, Boundary::limit, Boundary::open}[test::any(0, 2)]);
  const Gates gates{FreeSpace(world)};
  for (int n = 0; n < 6; ++n) {
    const Point s = test::any_fine_point(6), g = test::any_fine_point(6);
    const double r = test::any(1, 70) / 100.0 + 0.0013;
    RC_LOG(test::show(small) + fmt::format(" s {} g {} r {}\n", test::show(s), test::show(g), r));
    agrees_with_inflation(world, gates, s, g, r);
  }
}

RC_GTEST_PROP(DiscPassage, IsBoundedByTheWidest, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 7, .solids = 2});
  RC_LOG(test::show(small));
  const World world = small.bounded(Boundary::walled);
  const Gates gates{FreeSpace(world)};
  for (int n = 0; n < 6; ++n) {
    const Point s = test::any_fine_point(6), g = test::any_fine_point(6);
    const auto widest = widest_passage(gates, s, g);
    if (!widest) {
      RC_ASSERT(disc_passage(gates, s, g, 1e-9).status != DiscStatus::found);
      continue;
    }
    if (widest->radius == 0) continue;
    RC_LOG(fmt::format(" s {} g {} radius {}\n", test::show(s), test::show(g), widest->radius));
    RC_ASSERT(disc_passage(gates, s, g, widest->radius).status == DiscStatus::found);
    RC_ASSERT(disc_passage(gates, s, g, std::nextafter(widest->radius, 9)).status != DiscStatus::found);
    if (widest->radius < 1e-9) continue;  // the inflated world cannot be rounded that finely
    RC_ASSERT(inflated(world, s, g, widest->radius * 0.998) == true);
    RC_ASSERT(inflated(world, s, g, widest->radius * 1.0001) != true);
    const auto back = widest_passage(gates, g, s);
    RC_ASSERT(back && back->radius == widest->radius);
  }
}

RC_GTEST_PROP(DiscPassage, AgreesWithAFineGrid, ()) {
  const SmallWorld small = test::any_world({.side = 4, .walls = 5, .solids = 1});
  RC_LOG(test::show(small));
  const Gates gates{FreeSpace(small.bounded(Boundary::walled))};
  const int steps = 96;
  const double step = 4.0 / steps;
  const auto node = [&] { return Point{test::any(1, steps - 1) * step, test::any(1, steps - 1) * step}; };
  const Point s = node(), g = node();
  const double r = test::any(10, 60) / 100.0 + 0.0013;
  // A step keeps within 1/2 of a node; a free path stays within 0.71 steps of nodes.
  if (flooded(gates, s, g, r + 0.51 * step, 4, steps))
    RC_ASSERT(disc_passage(gates, s, g, r).status == DiscStatus::found);
  if (!flooded(gates, s, g, r - 0.72 * step, 4, steps))
    RC_ASSERT(disc_passage(gates, s, g, r).status != DiscStatus::found);
}

RC_GTEST_PROP(DiscPassage, AgreesWithTheInflatedPolygonInOpenedMazes, ()) {
  const int width = test::any(2, 6), height = test::any(2, 6), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(width, height, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  const World world = world_of(maze);
  const Gates gates{FreeSpace(world)};
  const Point s{test::any(0, width - 1) + 0.5, test::any(0, height - 1) + 0.5};
  const Point g{test::any(0, width - 1) + 0.5, test::any(0, height - 1) + 0.5};
  for (const double r : {0.1, 0.31, 0.498, 0.4993}) agrees_with_inflation(world, gates, s, g, r);
  const auto widest = widest_passage(gates, s, g);
  RC_ASSERT(widest && widest->radius >= 0.5);
}

}  // namespace
}  // namespace taut
