// Contour lines of the distance from a place.
#include <gtest/gtest.h>

#include <cmath>

#include <taut/io/pictures/contours.h>
#include <taut/search/shortest_path.h>

#include "support/small_world.h"

namespace taut {
namespace {

TEST(Contours, AreCirclesWhereNothingStands) {
  const FreeSpace space = test::SmallWorld{}.space();
  const auto lines = contours(space, {5, 5}, 5);
  ASSERT_GT(lines.size(), 100U);
  const double between = std::sqrt(50) / 5;
  for (const Segment& s : lines)
    for (const Point p : {s.a, s.b}) {
      const double ratio = std::hypot(p.x - 5, p.y - 5) / between;
      EXPECT_NEAR(ratio, std::round(ratio), 1e-3);
    }
}

TEST(Contours, GoAroundWallsAndDoNotCrossThem) {
  const FreeSpace space = test::SmallWorld{{{{5, 0}, {5, 8}}}}.space();
  const auto lines = contours(space, {1, 1}, 8);
  ASSERT_FALSE(lines.empty());
  const double between = shortest_path(space, {1, 1}, Point{10, 0})->length.value() / 8;
  for (std::size_t i = 0; i < lines.size(); i += 50) {
    const Segment& s = lines[i];
    EXPECT_FALSE((s.a.x < 5) != (s.b.x < 5) && s.a.y < 8 && s.b.y < 8);
    const double ratio = shortest_path(space, {1, 1}, s.a)->length.value() / between;
    EXPECT_NEAR(ratio, std::round(ratio), 0.02);
  }
}

}  // namespace
}  // namespace taut
