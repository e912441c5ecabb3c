// What a FreeSpace answers by its triangulation, against its constraints and polygons without any index.
#include <taut/geometry/free_space.h>

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/segment_distance.h>
#include <taut/geometry/written.h>

#include "support/constraint_walk.h"
#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::any;
using test::any_world;
using test::RandomWorld;

bool in_polygons(const FreeSpace& space, Point p) {
  return std::any_of(space.polygons().begin(), space.polygons().end(), [p](const Polygon& polygon) {
    return written::side_of_ring(p, polygon.outer) >= 0 &&
           std::none_of(polygon.holes.begin(), polygon.holes.end(),
                        [p](const Ring& hole) { return written::side_of_ring(p, hole) > 0; });
  });
}

/// Often where it hurts: a vertex, the middle of a side, a lattice point.
Point any_point(const FreeSpace& space, int side) {
  const auto& constraints = space.constraints();
  const int kind = any(0, 3);
  if (kind <= 1) {
    const Constraint& c = constraints[static_cast<std::size_t>(any(0, static_cast<int>(constraints.size()) - 1))];
    return kind == 0 ? c.a : Point{(c.a.x + c.b.x) / 2, (c.a.y + c.b.y) / 2};
  }
  const int grain = kind == 2 ? 1 : 8, x = any(-1, side * grain + 1), y = any(-1, side * grain + 1);
  return {double(x) / grain, double(y) / grain};
}

/// Calls f(space, p, q) for random worlds of several kinds.
template <class F>
void for_points_in_worlds(F f) {
  const RandomWorld kinds[] = {
      {}, {.side = 4, .walls = 14, .solids = 2, .straight = true}, {.walls = 5, .solids = 2, .thickness = 0.5}};
  const RandomWorld& kind = kinds[any(0, 2)];
  const auto world = any_world(kind);
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  RC_PRE(!space.constraints().empty());
  for (int i = 0; i < 20; ++i) {
    const Point p = any_point(space, kind.side), q = any_point(space, kind.side);
    RC_LOG() << test::show(p) << ' ' << test::show(q) << '\n';
    f(space, p, q);
  }
}

RC_GTEST_PROP(FreeSpace, LocatesAPointOutsideWhereThePolygonsAreNot, ()) {
  for_points_in_worlds([](const FreeSpace& space, Point p, Point) {
    RC_ASSERT((space.locate(p).kind != Location::Kind::outside) == in_polygons(space, p));
  });
}

RC_GTEST_PROP(FreeSpace, SeesWhatTheConstraintsLetThrough, ()) {
  for_points_in_worlds([](const FreeSpace& space, Point p, Point q) {
    const bool follows = in_polygons(space, p) && in_polygons(space, q) && test::follows({p, q}, space.constraints());
    RC_ASSERT(space.sees(p, q) == follows);
  });
}

RC_GTEST_PROP(FreeSpace, MeasuresTheClearanceToTheNearestConstraint, ()) {
  for_points_in_worlds([](const FreeSpace& space, Point p, Point) {
    if (!in_polygons(space, p)) return;
    const auto& constraints = space.constraints();
    std::uint32_t nearest = 0;
    for (std::uint32_t i = 1; i < constraints.size(); ++i) {
      const Constraint &c = constraints[i], &best = constraints[nearest];
      if (compare_segment_distances({p, p}, {c.a, c.b}, {p, p}, {best.a, best.b}) < 0) nearest = i;
    }
    const Clearance clearance = space.clearance(p);
    RC_ASSERT(clearance.constraint == nearest);
    RC_ASSERT(clearance.distance == segment_distance({p, p}, {constraints[nearest].a, constraints[nearest].b}));
  });
}

// How far an axis-parallel wall is, is known exactly at once; of a slanted one to rounding.
TEST(FreeSpace, NamesTheFirstOfEquallyNearConstraintsWhicheverWayTheyLie) {
  const std::vector<Segment> slanted{{{7, 1}, {-1, 7}}, {{-1, 7}, {7, 1}}, {{-7, -1}, {1, -7}}, {{7, -1}, {-1, -7}}};
  const std::vector<Segment> straight{{{-5, -1}, {-5, 1}}, {{5, -1}, {5, 0.5}}, {{-1, -5}, {1, -5}}, {{-1, 5}, {0, 5}}};
  for (const Segment& s : slanted)
    for (const Segment& t : straight) {
      const FreeSpace space = test::SmallWorld{{s, t}, {}, test::box_ring(-20, -20, 20, 20)}.space();
      const auto& constraints = space.constraints();
      const auto first = std::find_if(constraints.begin(), constraints.end(), [](const Constraint& c) {
        return compare_segment_distances({{0, 0}, {0, 0}}, {c.a, c.b}, {{0, 0}, {0, 0}}, {{5, 0}, {5, 0}}) == 0;
      });
      const Clearance clearance = space.clearance({0, 0});
      EXPECT_EQ(clearance.distance, 5);
      EXPECT_EQ(clearance.constraint, first - constraints.begin());
    }
}

RC_GTEST_PROP(FreeSpace, HasConstraintsThatMeetOnlyAtEnds, ()) {
  const auto world = any_world();
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const auto& c = space.constraints();
  for (std::size_t i = 0; i < c.size(); ++i) {
    RC_ASSERT(c[i].a != c[i].b);
    RC_ASSERT(!(c[i].solid_left && c[i].solid_right));
    for (std::size_t j = 0; j < i; ++j) {
      const Segment s{c[i].a, c[i].b}, t{c[j].a, c[j].b};
      RC_ASSERT(!written::cross_properly(s, t));
      for (const Point p : {s.a, s.b}) RC_ASSERT(p == t.a || p == t.b || !written::on_segment(p, t.a, t.b));
      for (const Point p : {t.a, t.b}) RC_ASSERT(p == s.a || p == s.b || !written::on_segment(p, s.a, s.b));
      RC_ASSERT(!((s.a == t.a && s.b == t.b) || (s.a == t.b && s.b == t.a)));
    }
  }
}

RC_GTEST_PROP(FreeSpace, MarksTheSolidSidesOfItsConstraintsConsistently, ()) {
  const auto world = any_world();
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  for (const Constraint& c : space.constraints()) {
    const Star star = test::star(c.a, space.constraints());
    const auto n = star.sector_count();
    for (std::uint32_t s = 0; s < n; ++s) RC_ASSERT(star.rays()[s].solid_ccw == star.rays()[(s + 1) % n].solid_cw);
  }
}

}  // namespace
}  // namespace taut
