#include <taut/geometry/cgal.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "support/random_world.h"

namespace taut {
namespace {

template <class Kernel>
void expect_round_trip() {
  const Polygon square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {0.1 + 2, 2}}}};
  EXPECT_EQ(from_cgal(to_cgal<Kernel>(square)), square);
  EXPECT_EQ(from_cgal(to_cgal<Kernel>(Point{0.1, -5e-324})), (Point{0.1, -5e-324}));
  EXPECT_EQ(from_cgal(to_cgal<Kernel>(Segment{{1, 2}, {3, 4}})), (Segment{{1, 2}, {3, 4}}));
}

TEST(CgalBridge, BringsEveryCoordinateBackUnchanged) {
  expect_round_trip<CGAL::Exact_predicates_inexact_constructions_kernel>();
  expect_round_trip<CGAL::Exact_predicates_exact_constructions_kernel>();
}

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

/// Of the free triangles: that has nothing to do with the rings.
Exact::FT area_of_triangles(const FreeSpace& space) {
  const Triangulation& tri = space.triangulation();
  Exact::FT doubled = 0;
  for (std::size_t t = 0; t < tri.triangles.size(); ++t) {
    if (!tri.free[t]) continue;
    const auto corner = [&](int i) { return to_cgal<Exact>(tri.points[tri.triangles[t][i]]); };
    doubled += CGAL::determinant(corner(1) - corner(0), corner(2) - corner(0));
  }
  return doubled / 2;
}

Footprint any_footprint() {
  switch (test::any(0, 3)) {
    case 0: return Footprint::point();
    case 1: return Footprint::disc(test::any(1, 8) / 16.0);
    case 2: return Footprint::square(test::any(1, 8) / 10.0);
    default: return Footprint::polygon({{0.5, 0}, {0, 0.25}, {-0.125, -0.3}});
  }
}

RC_GTEST_PROP(CgalPolygons, HaveTheAreaOfTheFreeTriangles, ()) {
  const auto small = test::any_world({.walls = 6, .solids = 2, .thickness = test::any(0, 2) / 5.0});
  RC_LOG(test::show(small));
  const FreeSpace space(small.bounded(test::any(0, 1) ? Boundary::walled : Boundary::limit), any_footprint());
  const auto polygons = cgal_polygons<Exact>(space);
  // A vertex in line as written is left out of the rings; as a double it may be beside the line.
  RC_ASSERT(CGAL::abs(cgal_area(polygons) - area_of_triangles(space)) < 1e-12);
  RC_ASSERT(polygons.size() == space.polygons().size());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    RC_ASSERT(polygons[i].outer_boundary().is_counterclockwise_oriented());
    for (const auto& hole : polygons[i].holes()) RC_ASSERT(hole.is_clockwise_oriented());
    RC_ASSERT(from_cgal(polygons[i]) == space.polygons()[i]);
  }
}

TEST(CgalPolygons, AreTheRoomWithoutItsThickWall) {
  test::SmallWorld room{.walls = {{{4, 5}, {6, 5}}}, .thickness = 1};
  const FreeSpace space(room.bounded(Boundary::walled), Footprint::square(0.5));
  const auto polygons = cgal_polygons(space);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].number_of_holes(), 1u);
  EXPECT_EQ(cgal_area(polygons), 9 * 9 - 4 * 2) << "the wall is 3 x 1 with its caps, and the robot adds 1 to both";
}

}  // namespace
}  // namespace taut
