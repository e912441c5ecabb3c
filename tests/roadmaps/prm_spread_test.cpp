// Sobol's samples, and the nearest of a set of points.
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/roadmaps/prm.h>
#include <taut/roadmaps/prm_nearest.h>

#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using test::SmallWorld;

TEST(Prm, DrawsOnePointOfSobolsSequenceInEachBoxOfEqualParts) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {}, .area = test::box_ring(-2, 1, 6, 9)}.space();
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const auto points = prm(space, {.sampler = PrmSampler::sobol, .samples = 256, .seed = seed}).points();
    ASSERT_EQ(points.size(), 256u);
    for (int columns = 1; columns <= 256; columns *= 2) {
      std::set<std::pair<int, int>> boxes;
      for (const Point p : points) boxes.emplace(int((p.x + 2) / 8 * columns), int((p.y - 1) / 8 * (256 / columns)));
      EXPECT_EQ(boxes.size(), 256u) << columns << " columns, seed " << seed;
    }
  }
}

/// By sorting all.
std::vector<std::uint32_t> nearest_of_all(const std::vector<Point>& points, Point p, std::size_t count) {
  std::vector<std::pair<double, std::uint32_t>> ranks;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double dx = points[i].x - p.x, dy = points[i].y - p.y;
    ranks.emplace_back(dx * dx + dy * dy, i);
  }
  std::sort(ranks.begin(), ranks.end());
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < std::min(count, ranks.size()); ++i) result.push_back(ranks[i].second);
  return result;
}

RC_GTEST_PROP(PrmNearest, FindsTheNearestInOrderAmongManyOfThemAtOnePlaceToo, ()) {
  std::vector<Point> points;
  const int spread = any(0, 1) ? 64 : 3;  // or many equally far, many the same
  for (int n = any(1, 300); n > 0; --n) points.push_back({any(0, spread) / 4.0, any(0, spread) / 4.0});
  if (any(0, 1)) points.push_back({1e6, -1e3});
  PrmNearest index;
  const auto half = static_cast<std::ptrdiff_t>(points.size() / 2);
  index.add(std::vector<Point>(points.begin(), points.begin() + half));
  index.add(std::vector<Point>(points.begin() + half, points.end()));
  const Point p{any(-4, spread) / 4.0, any(-4, spread) / 4.0};
  const auto count = static_cast<std::size_t>(any(1, 70));
  RC_ASSERT(index.nearest(p, count) == nearest_of_all(points, p, count));
}

}  // namespace
}  // namespace taut
