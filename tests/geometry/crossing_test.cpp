#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <support/small_world.h>
#include <taut/geometry/detail/quick_crossing.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/predicates.h>
#include <taut/geometry/written.h>

namespace taut {
namespace {

TEST(LineCrossing, IsExact) {
  const ExactPoint p = line_crossing({{0, 0}, {3, 1}}, {{0, 1}, {3, 0}});
  EXPECT_EQ(p, ExactPoint(Rational(3, 2), Rational(1, 2)));
  const ExactPoint third = line_crossing({{0, 0}, {1, 1}}, {{0, 1}, {2, -3}});
  EXPECT_EQ(third, ExactPoint(Rational(1, 3), Rational(1, 3)));
}

TEST(LineCrossing, HoldsFromTheSmallestToTheLargestNumbers) {
  for (const double unit : {0x1p-1000, 0x1p-300, 1.0, 0x1p240}) {
    const ExactPoint p = line_crossing({{0, 0}, {unit, unit}}, {{0, unit}, {2 * unit, -3 * unit}});
    EXPECT_EQ(p.x * 3, Rational(unit));
  }
}

TEST(QuickCrossing, RoundsAsRationalsDoOrSaysNothing) {
  std::mt19937_64 engine(1);
  const auto unit = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::size_t answers = 0, crossings = 0;
  for (int k = 0; k < 20000; ++k) {
    const double scale = std::ldexp(1.0, static_cast<int>(engine() % 45) - 25), offset = k % 3 == 0 ? 1e6 * scale : 0;
    const double flatness = k % 4 == 0 ? 1e-9 : 1;  // nearly parallel
    const bool lattice = k % 5 == 0;
    const auto point = [&] {
      const double x = lattice ? std::floor(unit() * 100) : unit(),
                   y = lattice ? std::floor(unit() * 100) : unit() * flatness;
      return Point{x * scale + offset, y * scale};
    };
    const Segment s{point(), point()}, t{point(), point()};
    if (!written::cross_properly(s, t)) continue;
    ++crossings;
    const DecimalUnit measure(100 * scale + offset);
    const auto quick = detail::quick_crossing(s, t, measure);
    if (!quick) continue;
    ++answers;
    const ExactPoint exact = line_crossing(s, t);
    ASSERT_EQ(quick->point, measure.nearest(exact));
    ASSERT_GE(quick->displacement, displacement(exact, quick->point) * (1 - 1e-15));
    ASSERT_FALSE(exact == ExactPoint(quick->point));
  }
  EXPECT_GT(crossings, 3000u);
  EXPECT_GT(answers, crossings * 8 / 10);
}

TEST(RoundOutward, StaysOffTheSolidSideOfAllEdges) {
  std::mt19937_64 engine(2);
  const auto unit = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  for (int k = 0; k < 2000; ++k) {
    const Segment s{{unit(), unit()}, {unit(), unit()}}, t{{unit(), unit()}, {unit(), unit()}};
    if (!written::cross_properly(s, t)) continue;
    const ExactPoint exact = line_crossing(s, t);
    const Segment edges[] = {s, t};
    const Point p = round_outward(exact, edges, DecimalUnit(1));
    EXPECT_LE(written::orientation(s.a, s.b, p), 0);
    EXPECT_LE(written::orientation(t.a, t.b, p), 0);
  }
}

TEST(RoundOutward, TakesTheNearestPlaceWhereNoDoubleLiesInTheWedge) {
  // Two sides of obstacles that face each other, apart by less than doubles can say along a thousandth of either.
  const Segment s{{1.1234567890123459, 0.5123456789012345}, {1.4234567890123457, 0.6123456789012347}};
  const Segment t{{1.4234567890123457, 0.6123456789012346}, {1.1234567890123459, 0.5123456789012346}};
  ASSERT_TRUE(written::cross_properly(s, t));
  const ExactPoint exact = line_crossing(s, t);
  const Segment edges[] = {s, t};
  EXPECT_THROW(round_outward(exact, edges, DecimalUnit(2)), TooFine);
  const Point p = round_outward_or_nearest(exact, edges, DecimalUnit(2));
  EXPECT_EQ(p, DecimalUnit(2).nearest(exact));
  EXPECT_LT(displacement(exact, p), 1e-14);
}

TEST(FreeSpaceOfComputedNumbers, IsMadeHoweverSharplyObstaclesMeet) {
  std::mt19937_64 engine(5);
  const auto unit = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  const auto beside = [&](double v) { return v + (unit() - 0.5) * 8 * 0x1p-51; };
  for (int k = 0; k < 300; ++k) {
    const Point a{2 + unit(), 2 + 6 * unit()}, b{7 + unit(), 2 + 6 * unit()};
    const Point c{beside(a.x), beside(a.y)}, d{beside(b.x), beside(b.y)};
    const FreeSpace space = test::SmallWorld{.solids = {{a, b, {5, 9.5}}, {d, c, {5, 0.5}}}}.space();
    double twice = 0;
    for (const Polygon& polygon : space.polygons()) {
      twice += ring_area(polygon.outer);
      for (const Ring& hole : polygon.holes) twice += ring_area(hole);
    }
    EXPECT_NEAR(twice, 200 - ring_area({a, b, {5, 9.5}}) - ring_area({d, c, {5, 0.5}}), 1e-9) << k;
  }
}

}  // namespace
}  // namespace taut
