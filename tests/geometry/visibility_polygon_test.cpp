
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/free_space.h>
#include <taut/geometry/predicates.h>
#include <taut/geometry/written.h>

#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using test::box_ring;
using test::SmallWorld;

double area(const VisibilityPolygon& v) { return ring_area(v.ring) / 2; }

TEST(VisibilityPolygonOfAPoint, IsTheWholeOfAnEmptyBox) {
  const auto v = SmallWorld{}.space().visibility_polygon({5, 5});
  EXPECT_EQ(area(v), 100);
  EXPECT_EQ(v.rounding, 0);
}

TEST(VisibilityPolygonOfAPoint, LosesTheShadowOfAWall) {
  // The wall hides the trapezoid behind it: corners (2, 4), (4, 4), (7, 10), (-1, 10) cut at x = 0.
  const FreeSpace space = SmallWorld{.walls = {{{4, 4}, {6, 4}}}, .solids = {}}.space();
  EXPECT_NEAR(area(space.visibility_polygon({5, 2})), 100 - (2 + 8) * 6 / 2, 1e-12);
}

TEST(VisibilityPolygonOfAPoint, OfACornerStartsAtTheCorner) {
  const FreeSpace space = SmallWorld{}.space();
  EXPECT_EQ(area(space.visibility_polygon({0, 0})), 100);
  EXPECT_EQ(area(space.visibility_polygon({5, 0})), 100);
}

TEST(VisibilityPolygonOfAPoint, OfAPointOnAWallIsWhatBothSidesSee) {
  const FreeSpace space = SmallWorld{.walls = {{{0, 5}, {10, 5}}}, .solids = {}}.space();
  EXPECT_EQ(area(space.visibility_polygon({5, 5})), 100);
  EXPECT_EQ(area(space.visibility_polygon({5, 6})), 50);
}

RC_GTEST_PROP(VisibilityPolygonOfAPoint, ContainsJustThePointsThatAreSeen, ()) {
  const SmallWorld world = test::any_world();
  const Point p{any(0, 24) / 4.0 + 1 / 64.0, any(0, 24) / 4.0 + 1 / 128.0};
  RC_LOG() << test::show(world) << '\n' << test::show(p) << '\n';
  const FreeSpace space = world.space();
  RC_PRE(space.locate(p).kind == Location::Kind::triangle);
  const VisibilityPolygon v = space.visibility_polygon(p);
  RC_ASSERT(v.rounding < 1e-14);
  for (int k = 0; k < 30; ++k) {
    // Off all lines through lattice points but a few: rounding can't matter.
    const Point q{any(0, 600) / 100.0 + 0.0037, any(0, 600) / 100.0 + 0.0071};
    RC_ASSERT((written::side_of_ring(q, v.ring) > 0) == space.sees(p, q));
  }
}

}  // namespace
}  // namespace taut
