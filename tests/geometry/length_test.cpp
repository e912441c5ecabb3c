#include <taut/geometry/length.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <cmath>
#include <random>
#include <vector>

#include "support/any_legs.h"

namespace taut::test {
namespace {

int ulps_wide(Interval i) {
  int steps = 0;
  for (double v = i.lo; v < i.hi && steps < 9; v = std::nextafter(v, i.hi)) ++steps;
  return steps;
}

void expect_tight(Point p, Point q) {
  const Interval i = distance_interval(p, q);
  EXPECT_TRUE(Reference({{p, q}}).is_in(i)) << p.x << " " << p.y << " " << q.x << " " << q.y;
  EXPECT_LE(ulps_wide(i), 2) << p.x << " " << p.y << " " << q.x << " " << q.y;
  EXPECT_EQ(i, distance_interval(q, p));
}

TEST(DistanceInterval, IsAPointWhereTheDistanceIsADouble) {
  EXPECT_EQ(distance_interval({1, 1}, {1, 1}), (Interval{0, 0}));
  EXPECT_EQ(distance_interval({0, 0}, {3, 4}), (Interval{5, 5}));
  EXPECT_EQ(distance_interval({0.25, 7}, {0.25, -9}), (Interval{16, 16}));
  EXPECT_EQ(distance_interval({0.1, 5}, {0, 5}), (Interval{0.1, 0.1}));
}

TEST(DistanceInterval, EnclosesLongAndShortDistances) {
  for (const double scale : {1e75, 1e40, 1.0, 1e-100, 1e-150, 1e-300, 5e-324}) {
    expect_tight({scale, 0}, {0, scale});
    expect_tight({scale, 3 * scale}, {-scale, 0.1 * scale});
    expect_tight({0, 1}, {scale, 0});
    expect_tight({-1, 1 + scale}, {0, 0});
  }
  expect_tight({1e75, 1e75}, {-1e75, -1e75});
  expect_tight({0, 0}, {1, 1e-200});
  expect_tight({0, 0}, {5e-324, 5e-324});
  expect_tight({1.7e308, 1}, {0, 0});
}

TEST(DistanceInterval, EnclosesRandomDistancesWithinTwoUlps) {
  std::mt19937_64 draw(1);
  const auto coordinate = [&] {
    const double mantissa = static_cast<double>(draw() >> 11) - 0x1p52;
    return std::ldexp(mantissa, -52 + static_cast<int>(draw() % 8));
  };
  for (int i = 0; i < 20000; ++i) {
    const double ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
    expect_tight({ax, ay}, {bx, by});
  }
}

TEST(Length, OfAChainIsTheSumOfItsLegs) {
  const std::vector<Point> chain{{0, 0}, {3, 4}, {3, 5}, {4, 6}};
  const Length length{std::span<const Point>(chain)};
  EXPECT_EQ(length.terms(), 3u);
  EXPECT_EQ(length, length_of({leg(0, 6), leg(1, 1)}));
  EXPECT_EQ(Length(std::span<const Point>(chain).first(1)), Length());
  EXPECT_EQ(Length().value(), 0);
  EXPECT_EQ(Length().decimals(3), "0.000");
}

TEST(Length, AddsItself) {
  Length length = length_of({leg(1, 1), leg(2, 0)});
  length += length;
  EXPECT_EQ(length, length_of({leg(2, 2), leg(4, 0)}));
  EXPECT_EQ(length.terms(), 4u);
}

TEST(Length, RoundsDecimalsCorrectlyAndTiesToEven) {
  EXPECT_EQ(length_of({leg(0, 0.5)}).decimals(0), "0");
  EXPECT_EQ(length_of({leg(0, 1.5)}).decimals(0), "2");
  EXPECT_EQ(length_of({leg(0, 0.125)}).decimals(2), "0.12");
  EXPECT_EQ(length_of({leg(0, 0.375)}).decimals(2), "0.38");
  EXPECT_EQ(length_of({leg(0, 0.25), leg(0, 0.25)}).decimals(0), "0");
  EXPECT_EQ(length_of({leg(1, 1)}).decimals(6), "1.414214");
  EXPECT_EQ(length_of({leg(1, 1)}).decimals(50), "1.41421356237309504880168872420969807856967187537695");
  EXPECT_EQ(length_of({leg(0, 1e20, {0, 0})}).decimals(1), "100000000000000000000.0");
  EXPECT_EQ(length_of({{{0, 0}, {0, 0x1p-100}}}).decimals(3), "0.000");
}

TEST(Length, SeesThatOnlyTheIrrationalPartMovesADecimal) {
  // 1/2 and a little more than nothing: 0.5 would go down to even, this may not.
  EXPECT_EQ(length_of({leg(0, 0.5, {0, 0}), {{0, 0}, {0x1p-300, 0x1p-300}}}).decimals(0), "1");
}

RC_GTEST_PROP(Length, ValueAndDecimalsAreCorrectlyRounded, ()) {
  const double unit = *rc::gen::element(1.0, 0.1, 1e60, 1e-100);
  const Legs legs = any_legs(*rc::gen::inRange(0, 12), 1000, unit);
  const Length length = length_of(legs);
  const Reference reference(legs);
  RC_ASSERT(length.value() == reference.nearest());
  RC_ASSERT(length.decimals(6) == reference.decimals(6));
  RC_ASSERT(reference.is_in(length.interval()));
}

RC_GTEST_PROP(Length, ScalesWithPowersOfTwo, ()) {
  const Legs legs = any_legs(*rc::gen::inRange(0, 12), 1000, 0.1);
  const int exponent = *rc::gen::inRange(-200, 200);
  Legs scaled = legs;
  for (Segment& s : scaled)
    for (double* v : {&s.a.x, &s.a.y, &s.b.x, &s.b.y}) *v = std::ldexp(*v, exponent);
  RC_ASSERT(length_of(scaled).value() == std::ldexp(length_of(legs).value(), exponent));
  RC_ASSERT(length_of(scaled).interval().lo == std::ldexp(length_of(legs).interval().lo, exponent));
  RC_ASSERT(length_of(scaled).interval().hi == std::ldexp(length_of(legs).interval().hi, exponent));
}

TEST(Length, IntervalsOfManyLegsStayNarrow) {
  Length length;
  for (int i = 0; i < 10000; ++i) length.add({0, 0}, {0.1 * i, 1});
  EXPECT_LT((length.interval().hi - length.interval().lo) / length.interval().hi, 2e-12);
  EXPECT_GE(length.value(), length.interval().lo);
  EXPECT_LE(length.value(), length.interval().hi);
}

TEST(Length, OfWhatIsNoNumberIsNone) {
  EXPECT_TRUE(std::isnan(Length(std::vector<Point>{{0, 0}, {NAN, 1}, {2, 2}}).value()));
  EXPECT_EQ(Length(std::vector<Point>{{0, 0}, {HUGE_VAL, 1}}).value(), HUGE_VAL);
}

}  // namespace
}  // namespace taut::test
