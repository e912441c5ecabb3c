#include <taut/geometry/segment_distance.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/written.h>

namespace taut {
namespace {

TEST(SegmentDistance, IsZeroWhereSegmentsMeet) {
  EXPECT_EQ(segment_distance({{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}), 0);
  EXPECT_EQ(segment_distance({{0, 0}, {2, 2}}, {{2, 2}, {3, 0}}), 0);
  EXPECT_EQ(segment_distance({{1, 1}, {1, 1}}, {{0, 0}, {2, 2}}), 0);
  EXPECT_EQ(segment_distance({{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}), 0);
}

TEST(SegmentDistance, IsMeasuredFromTheRightPlace) {
  EXPECT_EQ(segment_distance({{0, 0}, {4, 0}}, {{2, 3}, {2, 5}}), 3) << "above the middle";
  EXPECT_EQ(segment_distance({{0, 0}, {4, 0}}, {{7, 4}, {9, 9}}), 5) << "beyond the end";
  EXPECT_EQ(segment_distance({{0, 0}, {0, 0}}, {{3, 4}, {3, 4}}), 5) << "points";
  EXPECT_EQ(segment_distance({{0, 0}, {4, 4}}, {{4, 0}, {9, 0}}), std::sqrt(8.0)) << "aslant";
}

TEST(SegmentDistance, HoldsForTheLargestAndSmallestNumbers) {
  EXPECT_EQ(segment_distance({{0, 0}, {1e75, 0}}, {{0, 3e74}, {1e75, 3e74}}), 3e74);
  EXPECT_DOUBLE_EQ(segment_distance({{0, 0}, {1e75, 1e75}}, {{0, 1e-75}, {-1, 1}}), std::sqrt(0.5) * 1e-75);
  EXPECT_EQ(compare_segment_distances({{0, 0}, {1e-200, 1e-200}}, {{0, 1e-200}, {0, 1}}, {{0, 0}, {1e-200, 1e-200}},
                                      {{0, 2e-200}, {0, 1}}),
            -1);
}

TEST(SegmentDistance, IsComparedBeyondTheLastBit) {
  const Segment slope{{0, 0}, {3, 1}}, near{{1, 2}, {0, 5}}, far{{1, std::nextafter(2, 3)}, {0, 5}};
  EXPECT_EQ(compare_segment_distances(slope, near, slope, far), -1);
  EXPECT_EQ(compare_segment_distances(slope, far, slope, near), 1);
  EXPECT_EQ(compare_segment_distances(slope, near, {{10, 0}, {13, 1}}, {{11, 2}, {10, 5}}), 0);
}

/// A squared distance as an exact fraction of small integers.
struct Fraction {
  std::int64_t over, under;
  friend bool operator<(const Fraction& a, const Fraction& b) { return a.over * b.under < b.over * a.under; }
};

Fraction squared(Point p, Point a, Point b) {
  const auto n = [](double v) { return static_cast<std::int64_t>(v); };
  const auto ux = n(b.x - a.x), uy = n(b.y - a.y), vx = n(p.x - a.x), vy = n(p.y - a.y), wx = n(p.x - b.x),
             wy = n(p.y - b.y);
  const auto along = ux * vx + uy * vy, length = ux * ux + uy * uy, cross = ux * vy - uy * vx;
  if (0 < along && along < length) return {cross * cross, length};
  return std::min(Fraction{vx * vx + vy * vy, 1}, Fraction{wx * wx + wy * wy, 1});
}

Fraction squared(const Segment& s, const Segment& t) {
  if (written::segments_meet(s, t)) return {0, 1};
  return std::min({squared(s.a, t.a, t.b), squared(s.b, t.a, t.b), squared(t.a, s.a, s.b), squared(t.b, s.a, s.b)});
}

Segment any_segment() {
  const auto any = [] { return double(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-9, 10))); };
  const double ax = any(), ay = any(), bx = any(), by = any();
  return {{ax, ay}, {bx, by}};
}

RC_GTEST_PROP(SegmentDistance, AgreesWithFractions, ()) {
  for (int i = 0; i < 20; ++i) {
    const Segment s = any_segment(), t = any_segment(), u = any_segment();
    const Fraction first = squared(s, t), second = squared(s, u);
    RC_ASSERT(compare_segment_distances(s, t, s, u) == int(second < first) - int(first < second));
    const Interval interval = segment_distance_interval(s, t);
    const double root = std::sqrt(double(first.over) / double(first.under));
    RC_ASSERT(interval.lo <= std::nextafter(root, HUGE_VAL) && std::nextafter(root, 0) <= interval.hi);
    RC_ASSERT(interval.hi - interval.lo <= 1e-12);
    RC_ASSERT(std::abs(segment_distance(s, t) - root) <= root * 0x1p-51);
  }
}

RC_GTEST_PROP(SegmentDistance, DoesNotDependOnDirectionOrOrder, ()) {
  const Segment s = any_segment(), t = any_segment(), back{s.b, s.a};
  RC_ASSERT(segment_distance(s, t) == segment_distance(t, s));
  RC_ASSERT(segment_distance(s, t) == segment_distance(back, t));
  RC_ASSERT(compare_segment_distances(s, t, t, back) == 0);
}

// Found by predicates_fuzz: what two doubles enclose may overlap.
TEST(SegmentDistance, IsEnclosedOfNumbersALastBitApart) {
  const double x = std::nextafter(-0.3, -1);
  const Segment s{{-0.3, 0.6}, {1.2, -0.4}}, t{{x, 1.1}, {x, 0.1}};
  const Interval enclosed = segment_distance_interval(s, t);
  EXPECT_LE(enclosed.lo, segment_distance(s, t));
  EXPECT_GE(enclosed.hi, segment_distance(s, t));
}

// Found by predicates_fuzz: doubles that are whole, and yet not what they mean.
TEST(SegmentDistance, IsEnclosedBeyondTheWholeNumbersThatDoublesHold) {
  const Segment s{{0, 0}, {4.499997e24, 4.499996666666667e45}},
      t{{4.5e11, 4.5000003333333324e51}, {4.499998e24, 4.500004e45}};
  const Interval enclosed = segment_distance_interval(s, t);
  const double nearest = segment_distance(s, t);
  EXPECT_LE(enclosed.lo, nearest);
  EXPECT_GE(enclosed.hi, nearest);
}

}  // namespace
}  // namespace taut
