// The same axis-parallel worlds by their own road and, for one slope where nobody can be, by the general one.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <taut/geometry/free_space.h>
#include <taut/geometry/predicates.h>
#include <taut/search/shortest_path.h>

namespace taut {
namespace {

constexpr int kSide = 8;

class Worlds {
 public:
  explicit Worlds(unsigned seed) : random_(seed) {
    parts_.boundary = any(0, 1) ? Boundary::limit : Boundary::walled;
    parts_.areas = {{box(0, 0, kSide + 2, kSide), 0}};
    if (any(0, 3) == 0) parts_.areas.front().polygon.holes = {box(2, 2, 2 + any(1, 4), 2 + any(1, 4)).outer};
    for (int n = any(0, 12); n > 0; --n) parts_.walls.push_back(any_wall());
    for (int n = any(0, 4); n > 0; --n) parts_.solids.push_back(any_solid());
    parts_.solids.push_back({box(kSide + 1, 0, kSide + 2, 1), 0});
  }

  World straight() const { return World(parts_); }

  /// With a wall inside of the last solid.
  World with_slope() const {
    WorldParts parts = parts_;
    parts.walls.push_back({{kSide + 1.25, 0.25}, {kSide + 1.75, 0.5}, 0, 0});
    return World(std::move(parts));
  }

  /// A corner of the lattice or between two.
  Point any_place() { return {any(0, 2 * kSide) / 2.0, any(0, 2 * kSide) / 2.0}; }

 private:
  int any(int least, int most) { return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1)); }
  static Polygon box(double x, double y, double u, double v) { return {{{x, y}, {u, y}, {u, v}, {x, v}}, {}}; }

  Wall any_wall() {
    const double x = any(0, kSide), y = any(0, kSide), to = any(0, kSide);
    const double thickness = any(0, 4) == 0 ? 0.25 * any(1, 3) : 0;
    return {{x, y}, any(0, 1) ? Point{to, y} : Point{x, to}, thickness, 0};
  }

  Area any_solid() {
    const double x = any(0, kSide - 1), y = any(0, kSide - 1), width = any(1, 4), height = any(1, 4);
    Polygon polygon = box(x, y, std::min<double>(x + width, kSide), std::min<double>(y + height, kSide));
    // An island's lake, when there is room.
    if (width == 4 && height == 4 && x + 4 <= kSide && y + 4 <= kSide)
      polygon.holes = {box(x + 1, y + 1, x + 3, y + 3).outer};
    return {polygon, 0};
  }

  std::mt19937 random_;
  WorldParts parts_;
};

double doubled_area(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) {
    sum += ring_area(polygon.outer);
    for (const Ring& hole : polygon.holes) sum += ring_area(hole);
  }
  return sum;
}

/// -1: not free; infinite: there is none.
double length(const FreeSpace& space, Point from, Point to) {
  if (space.locate(from).kind == Location::Kind::outside || space.locate(to).kind == Location::Kind::outside) return -1;
  const std::optional<Path> path = shortest_path(space, from, to);
  return path ? path->length.value() : HUGE_VAL;
}

TEST(AxisParallelWorlds, HaveTheAnswersThatTheGeneralRoadGives) {
  int found = 0, none = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Worlds worlds(seed);
    const FreeSpace space(worlds.straight()), other(worlds.with_slope());
    ASSERT_EQ(space.polygons().size(), other.polygons().size());
    ASSERT_EQ(doubled_area(space.polygons()), doubled_area(other.polygons()));
    ASSERT_EQ(space.component_count(), other.component_count());
    ASSERT_EQ(space.constraints().size(), other.constraints().size());
    for (int query = 0; query < 4; ++query) {
      const Point from = worlds.any_place(), to = worlds.any_place();
      const double one = length(space, from, to), two = length(other, from, to);
      if (std::isinf(two)) ++none;
      if (two > 0 && !std::isinf(two)) ++found;
      if (one == two) continue;
      ASSERT_NEAR(one, two, 1e-12) << from.x << ',' << from.y << " to " << to.x << ',' << to.y;
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(none, 500);
}

}  // namespace
}  // namespace taut
