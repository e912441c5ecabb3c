#include <taut/search/disc_reach.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/predicates.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;

/// Two rooms with a door 2 wide.
PassageIndex rooms() {
  return PassageIndex(
      FreeSpace(SmallWorld{.walls = {{{5, 0}, {5, 4}}, {{5, 6}, {5, 10}}}, .solids = {}}.bounded(Boundary::walled)));
}

bool holds(const DiscReach& reach, Point p) {
  return std::any_of(reach.places.begin(), reach.places.end(), [&](const Polygon& polygon) {
    return side_of_ring(p, polygon.outer) >= 0 &&
           std::all_of(polygon.holes.begin(), polygon.holes.end(),
                       [&](const Ring& hole) { return side_of_ring(p, hole) <= 0; });
  });
}

TEST(DiscReach, EndsAtADoorThatIsTooNarrow) {
  const PassageIndex index = rooms();
  const auto reach = disc_reach(index, {2, 5}, 1.25);
  ASSERT_TRUE(reach);
  // A room less the rim, and into the door as far as the ends of wall let the centre come: 3/4 of the way.
  const double area = 2.5 * 7.5 + 2 * (1.25 - (0.75 + 1.25 * 1.25 * std::asin(0.8)) / 2);
  EXPECT_NEAR(reach->area, area, 0.02);
  EXPECT_NEAR(reach->whole_area, 2 * area, 0.04);
  ASSERT_EQ(reach->gates.size(), 1U);
  EXPECT_EQ(index.gates().name(reach->gates[0]), "2 between (5, 4) and (5, 6)");
}

TEST(DiscReach, GoesThroughADoorOfItsOwnWidth) {
  const auto reach = disc_reach(rooms(), {2, 5}, 1);
  ASSERT_TRUE(reach);
  EXPECT_TRUE(holds(*reach, {8, 5})) << "though no polygon around the disc gets through";
  EXPECT_TRUE(reach->gates.empty());
}

TEST(DiscReach, IsNothingWhereTheDiscCannotBe) { EXPECT_FALSE(disc_reach(rooms(), {2, 9.5}, 1)); }

RC_GTEST_PROP(DiscReach, HoldsThePlacesThatPassagesLeadTo, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 7, .solids = 2});
  RC_LOG(test::show(small));
  const PassageIndex index(FreeSpace(small.bounded(test::any(0, 1) ? Boundary::walled : Boundary::limit)));
  const Point s = test::any_fine_point(6);
  const double r = test::any(5, 60) / 100.0 + 0.0013, more = r * (1 + 1.001 * Footprint::kDiscExcess);
  RC_LOG(fmt::format(" s {} r {}\n", test::show(s), r));
  const auto reach = disc_reach(index, s, r);
  RC_ASSERT(reach.has_value() == (index.passes(s, s, r) == DiscStatus::found));
  if (!reach) return;
  for (const std::uint32_t gate : reach->gates) RC_ASSERT(index.gate_radius(gate) < r);
  for (int n = 0; n < 20; ++n) {
    const Point p = test::any_fine_point(6);
    RC_LOG(fmt::format(" p {}\n", test::show(p)));
    if (holds(*reach, p)) RC_ASSERT(index.passes(s, p, r) == DiscStatus::found);
    if (index.passes(s, s, more) == DiscStatus::found && index.passes(s, p, more) == DiscStatus::found)
      RC_ASSERT(holds(*reach, p));
  }
}

}  // namespace
}  // namespace taut
