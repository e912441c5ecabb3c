// An index against cones of sight: on small messy worlds, from all kinds of places, lengths exactly.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/written.h>
#include <taut/search/detail/index_builder.h>
#include <taut/search/index.h>
#include <taut/search/polyanya.h>
#include <taut/search/verify.h>

#include "support/messy_world.h"
#include "support/random_world.h"

namespace taut {
namespace {

using namespace test;

std::optional<FreeSpace> space_of(const WorldParts& parts) {
  try {
    return FreeSpace(World(parts));
  } catch (const InputError&) {
    return std::nullopt;  // walls that meet more sharply than doubles can say
  }
}

bool is_free(const FreeSpace& space, Point p) { return space.locate(p).kind != Location::Kind::outside; }

/// Corners, places on walls and on sides of triangles, and elsewhere on and off the lattice.
std::vector<Point> any_places(const FreeSpace& space, double side, int count) {
  std::vector<Point> places;
  const auto& corners = space.triangulation().points;
  for (int n = 0; n < count; ++n) {
    const int kind = any(0, 3), fine = kind == 0 ? 1 : kind == 1 ? 2 : kind == 2 ? 10 : 1 << 20;
    const int x = any(0, static_cast<int>(side) * fine), y = any(0, static_cast<int>(side) * fine);
    const Point p{static_cast<double>(x) / fine, static_cast<double>(y) / fine};
    if (is_free(space, p)) places.push_back(p);
    if (any(0, 4) > 0) continue;
    const Point corner = corners[static_cast<std::size_t>(any(0, static_cast<int>(corners.size()) - 1))];
    if (is_free(space, corner)) places.push_back(corner);
  }
  return places;
}

/// As the index has them: a point that lies in line as written adds some to the sum of its legs' doubles.
std::vector<Point> straightened(const std::vector<Point>& points) {
  std::vector<Point> kept;
  for (const Point p : points) {
    if (kept.size() > 1 && written::on_segment(kept.back(), kept[kept.size() - 2], p)) kept.pop_back();
    kept.push_back(p);
  }
  return kept;
}

std::string fault(IndexSearch& index, PolyanyaSearch& cones, const FreeSpace& space, Point from, Point to) {
  const SearchStatus expected = cones.find(from, to), found = index.find(from, to);
  if (found != expected) return "one finds a path, the other none";
  if (found != SearchStatus::found) return index.points().empty() ? "" : "points of no path";
  const Path path{index.points(), Length(index.points())};
  const Length shortest(straightened(cones.points()));
  if (path.length != shortest) return fmt::format("{} instead of {}", path.length.value(), shortest.value());
  if (std::abs(index.length() - path.length.value()) > 1e-9) return "not its own length";
  return verify(path, space, from, {to, {}}).valid ? "" : "goes through a wall";
}

/// Of all bends, or of a core of some.
Index any_index(const FreeSpace& space) {
  if (any(0, 1) == 0) return Index(space);
  const VisibilityGraph graph(space);
  const auto bytes = std::make_shared<const std::vector<std::byte>>(
      detail::index_bytes(graph, std::size_t{1} << 24, static_cast<std::size_t>(any(1, 12))).value());
  return {space, *bytes, bytes};
}

void agree_in(const FreeSpace& space, double side, const std::string& shown, int count) {
  IndexSearch index{any_index(space)};
  PolyanyaSearch cones{Polyanya(space)};
  const std::vector<Point> places = any_places(space, side, count);
  for (const Point from : places)
    for (const Point to : places)
      if (const std::string wrong = fault(index, cones, space, from, to); !wrong.empty())
        RC_FAIL(fmt::format("{} from {} to {}: {}", shown, show(from), show(to), wrong));
}

void agree_in(const SmallWorld& world, int count) {
  if (const auto space = space_of(world.parts())) agree_in(*space, world.area[2].x, show(world), count);
}

RC_GTEST_PROP(IndexProperty, HasTheShortestPaths, ()) { agree_in(any_world(), 14); }

RC_GTEST_PROP(IndexProperty, HasTheShortestPathsAmongManyThinWalls, ()) {
  agree_in(any_world({.side = 5, .walls = 25, .solids = 0}), 14);
}

RC_GTEST_PROP(IndexProperty, HasTheShortestPathsWhereEverythingIsRightAngled, ()) {
  agree_in(any_world({.side = 9, .walls = 24, .solids = 5, .straight = true}), 14);
}

RC_GTEST_PROP(IndexProperty, HasTheShortestPathsBetweenThickWalls, ()) {
  agree_in(any_world({.side = 9, .walls = 6, .solids = 1, .thickness = 0.3}), 10);
}

RC_GTEST_PROP(IndexProperty, HasTheShortestPathsInDecimals, ()) {
  WorldParts parts = any_world({.side = 9, .walls = 14, .solids = 3}).parts();
  const auto tenth = [](Point p) { return Point{p.x / 10, p.y / 10}; };
  for (Wall& wall : parts.walls) wall.a = tenth(wall.a), wall.b = tenth(wall.b);
  for (std::vector<Area>* areas : {&parts.areas, &parts.solids})
    for (Area& area : *areas)
      for (Point& p : area.polygon.outer) p = tenth(p);
  if (const auto space = space_of(parts)) agree_in(*space, 1, "in tenths", 14);
}

RC_GTEST_PROP(IndexProperty, HasTheShortestPathsOffEveryLattice, ()) {
  const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
  MessyWorld world = messy_world(seed);
  world.footprint = Footprint::point();
  if (const auto space = space_of(world.parts)) agree_in(*space, 10, fmt::format("messy_world({})", seed), 8);
}

}  // namespace
}  // namespace taut
