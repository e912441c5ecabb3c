// What is told at once to be in order, against the gate that looks at all pairs of sides.
#include <taut/geometry/detail/axis_rings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include <taut/geometry/detail/polygon_validation.h>
#include <taut/geometry/occupancy_world.h>

namespace taut {
namespace {

/// Off the integers, where nothing is told at once.
Polygon in_tenths(Polygon polygon) {
  const auto divide = [](Ring& ring) {
    for (Point& p : ring) p = {p.x / 10, p.y / 10};
  };
  divide(polygon.outer);
  std::ranges::for_each(polygon.holes, divide);
  return polygon;
}

bool is_regular(const Polygon& polygon) {
  std::vector<detail::Flaw> flaws;
  return detail::admit(in_tenths(polygon), flaws).size() == 1 && flaws.empty();
}

/// A rectangle with a corner that is cut out, or a side that has more corners than it needs; in either direction.
Ring any_ring(std::mt19937& random, int side) {
  const auto any = [&](int least, int most) {
    return static_cast<double>(least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1)));
  };
  const double x = any(0, side), y = any(0, side), u = x + any(1, 4), v = y + any(1, 4);
  Ring ring{{x, y}, {u, y}, {u, v}, {x, v}};
  const double w = any(0, side), z = any(0, side);
  if (random() % 2) {
    ring[2] = {u, z};
    ring.insert(ring.begin() + 3, {{w, z}, {w, v}});
  }
  if (random() % 3 == 0) ring.insert(ring.begin() + 1, {any(0, side), y});
  if (random() % 2) std::reverse(ring.begin(), ring.end());
  return ring;
}

TEST(AxisRings, AreSurelyRegularOnlyWhereTheGateSaysSo) {
  std::mt19937 random(1);
  int sure = 0;
  for (int round = 0; round < 60000; ++round) {
    const int side = 3 + static_cast<int>(random() % 6);
    Polygon polygon{any_ring(random, side), {}};
    if (random() % 3) polygon.outer = {{0, 0}, {12, 0}, {12, 12}, {0, 12}};
    for (unsigned holes = random() % 4; holes > 0; --holes) polygon.holes.push_back(any_ring(random, side));
    if (!detail::is_surely_regular(polygon)) continue;
    ++sure;
    ASSERT_TRUE(is_regular(polygon)) << "round " << round;
  }
  EXPECT_GT(sure, 5000);
}

TEST(AxisRings, AreSurelyRegularAroundTheBlocksOfAMap) {
  std::mt19937 random(2);
  for (int round = 0; round < 300; ++round) {
    OccupancyGrid grid{
        1 + static_cast<std::uint32_t>(random() % 12), 1 + static_cast<std::uint32_t>(random() % 12), {}};
    for (std::uint32_t i = 0; i < grid.width * grid.height; ++i) grid.blocked.push_back(random() % 2);
    const World world = world_of(grid);
    for (const Area& solid : world.solids()) EXPECT_TRUE(detail::is_surely_regular(solid.polygon));
  }
}

TEST(AxisRings, AreTurnedAsTheGateTurnsThem) {
  std::vector<detail::Flaw> flaws;
  const Polygon polygon{{{0, 0}, {0, 9}, {9, 9}, {9, 0}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}};
  const std::vector<Polygon> admitted = detail::admit(polygon, flaws);
  ASSERT_EQ(admitted.size(), 1U);
  EXPECT_EQ(admitted[0].outer, (Ring{{0, 0}, {9, 0}, {9, 9}, {0, 9}}));
  EXPECT_EQ(admitted[0].holes[0], (Ring{{1, 1}, {1, 2}, {2, 2}, {2, 1}}));
}

TEST(AxisRings, AreLeftToTheGateWhereTheySlopeOrMeetAlongSides) {
  EXPECT_FALSE(detail::is_surely_regular({{{0, 0}, {4, 1}, {4, 4}, {0, 4}}, {}}));
  EXPECT_FALSE(detail::is_surely_regular({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{0, 1}, {1, 1}, {1, 2}, {0, 2}}}}));
  EXPECT_FALSE(detail::is_surely_regular({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{0, 0}, {0, 0}}}}));
}

}  // namespace
}  // namespace taut
