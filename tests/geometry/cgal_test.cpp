#include <taut/geometry/cgal.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace taut
