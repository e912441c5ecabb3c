// All pairs at once against Polyanya, pair by pair: another mesh, another search, another sum.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/search/distance_matrix.h>
#include <taut/search/polyanya.h>

#include "support/messy_world.h"
#include "support/random_world.h"

namespace taut {
namespace {

using namespace test;

std::optional<FreeSpace> space_of(const SmallWorld& world) {
  try {
    return world.space();
  } catch (const InputError&) {
    return std::nullopt;  // walls that meet more sharply than doubles can say
  }
}

/// Corners, places on walls and on sides of triangles among them.
std::vector<Point> any_free_points(const FreeSpace& space, int side, int count) {
  std::vector<Point> points;
  for (int n = 0; n < count; ++n) {
    const int fine = any(0, 2) == 0 ? 1 : 4;
    const int x = any(0, side * fine), y = any(0, side * fine);
    const Point p{static_cast<double>(x) / fine, static_cast<double>(y) / fine};
    if (space.locate(p).kind != Location::Kind::outside) points.push_back(p);
  }
  return points;
}

double length_of(PolyanyaSearch& search, Point from, Point to) {
  if (search.find(from, to) != SearchStatus::found) return std::numeric_limits<double>::infinity();
  return Length(search.points()).value();
}

void agree_in(const SmallWorld& world, int count) {
  const auto space = space_of(world);
  if (!space) return;
  const std::vector<Point> points = any_free_points(*space, static_cast<int>(world.area[2].x), count);
  const std::vector<double> lengths = distance_matrix(*space, points);
  PolyanyaSearch search{Polyanya(*space)};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j) {
      const double expected = length_of(search, points[i], points[j]), found = lengths[i * points.size() + j];
      if (found != expected)
        RC_FAIL(fmt::format("{} from {} to {}: {} instead of {}", show(world), show(points[i]), show(points[j]), found,
                            expected));
    }
}

RC_GTEST_PROP(DistanceMatrixProperty, HasTheLengthsOfSinglePaths, ()) { agree_in(any_world(), 20); }

RC_GTEST_PROP(DistanceMatrixProperty, HasTheLengthsOfSinglePathsAmongManyThinWalls, ()) {
  agree_in(any_world({.side = 5, .walls = 25, .solids = 0}), 20);
}

RC_GTEST_PROP(DistanceMatrixProperty, HasTheLengthsOfSinglePathsWhereEverythingIsRightAngled, ()) {
  agree_in(any_world({.side = 7, .walls = 20, .solids = 4, .straight = true}), 20);
}

RC_GTEST_PROP(DistanceMatrixProperty, HasTheLengthsOfSinglePathsBetweenThickWalls, ()) {
  agree_in(any_world({.side = 9, .walls = 6, .solids = 1, .thickness = 0.3}), 15);
}

}  // namespace
}  // namespace taut
