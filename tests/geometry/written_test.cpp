#include <taut/geometry/written.h>

#include <charconv>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <taut/geometry/exact/numbers.h>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/predicates.h>

namespace taut {
namespace {

using written::decimal;
using written::Decimal;

TEST(WrittenNumber, MeansItsDecimalWhenThatHasFifteenDigits) {
  EXPECT_EQ(decimal(0.1), (Decimal{1, 1}));
  EXPECT_EQ(decimal(-12.5), (Decimal{-125, 1}));
  EXPECT_EQ(decimal(1200.0), (Decimal{12, -2}));
  EXPECT_EQ(decimal(0.0), (Decimal{0, 0}));
  EXPECT_EQ(decimal(5412345.678), (Decimal{5412345678, 3}));
  EXPECT_EQ(decimal(1e75), (Decimal{1, -75}));
  EXPECT_EQ(decimal(3e-120), (Decimal{3, 120}));
  EXPECT_EQ(decimal(123456789012345.0), (Decimal{123456789012345, 0}));
}

TEST(WrittenNumber, IsComputedWhenItTakesMoreDigits) {
  EXPECT_EQ(decimal(0.1 + 0.2), std::nullopt);
  EXPECT_EQ(decimal(std::sqrt(2)), std::nullopt);
  EXPECT_EQ(decimal(std::nextafter(1.0, 2.0)), std::nullopt);
  EXPECT_EQ(decimal(1234567890123456.0), std::nullopt);
}

/// What the shortest text says.
std::optional<Decimal> decimal_of_text(double v) {
  char text[40];
  char* end = std::to_chars(text, text + sizeof text, v, std::chars_format::scientific).ptr;
  const std::string s(text, end);
  const std::size_t e = s.find('e');
  std::string digits;
  for (const char c : s.substr(0, e))
    if (c != '.') digits += c;
  const int count = static_cast<int>(digits.size()) - (v < 0);
  if (count > 15) return std::nullopt;
  Decimal d{std::stoll(digits), count - 1 - std::stoi(s.substr(e + 1))};
  for (; d.digits != 0 && d.digits % 10 == 0; d.digits /= 10) --d.places;
  return d;
}

TEST(WrittenNumber, IsWhatTheShortestTextSays) {
  std::mt19937_64 engine(1);
  for (int k = 0; k < 200000; ++k) {
    const auto digits = static_cast<std::int64_t>(engine() % 2'000'000'000'000'000) >> (engine() % 40);
    const int places = static_cast<int>(engine() % 44) - 10;
    const double v = std::stod(std::to_string(digits) + "e" + std::to_string(-places));
    ASSERT_EQ(decimal(v), decimal_of_text(v)) << digits << " " << places;
    if (const auto d = decimal(v); d && digits != 0) {
      ASSERT_EQ(written::number(d->digits, d->places), v);
    }
    const double computed = std::ldexp(static_cast<double>(engine() >> 11), static_cast<int>(engine() % 120) - 100);
    ASSERT_EQ(decimal(computed), decimal_of_text(computed)) << computed;
  }
}

TEST(WrittenNumber, AddsAsPeopleDo) {
  EXPECT_EQ(written::sum(0.7, 0.1), 0.8);
  EXPECT_EQ(written::sum(0.1, 0.2), 0.3);
  EXPECT_EQ(written::difference(0.3, 0.1), 0.2);
  EXPECT_EQ(written::middle(0.3, 0.4), 0.35);
  EXPECT_EQ(written::times(3, 0.1), 0.3);
  EXPECT_EQ(written::compare_sum(0.1, 0.2, 0.3), 0);
  EXPECT_EQ(written::compare_sum(0.1, 0.2, 0.1 + 0.2), -1);
}

Rational exact_area(Point a, Point b, Point c) {
  const ExactPoint p(a), q(b), r(c);
  return (p.x - r.x) * (q.y - r.y) - (p.y - r.y) * (q.x - r.x);
}

TEST(WrittenOrientation, SaysWhatTheDecimalsSay) {
  EXPECT_EQ(written::orientation({0, 0.6}, {4, 3.1}, {0.8, 1.1}), 0);
  EXPECT_NE(orientation({0, 0.6}, {4, 3.1}, {0.8, 1.1}), 0);
  std::mt19937_64 engine(2);
  int zeros = 0;
  for (int k = 0; k < 20000; ++k) {
    const int places = static_cast<int>(engine() % 8);
    const double offset = k % 3 == 0 ? 5.4e6 : 0;
    const bool mixed = k % 5 == 0;
    const auto number = [&] {
      const double v = written::sum(offset, written::number(static_cast<int>(engine() % 2000) - 1000, places));
      return mixed && engine() % 4 == 0 ? std::nextafter(v, 1e9) : v;
    };
    const Point a{number(), number()}, d{number(), number()};
    // Half of the points are on the line, in decimals.
    const int t = static_cast<int>(engine() % 5);
    const Point b = k % 2 == 0 ? d
                               : Point{written::sum(a.x, written::times(t, written::difference(d.x, a.x))),
                                       written::sum(a.y, written::times(t, written::difference(d.y, a.y)))};
    const Point c = k % 2 == 0 ? Point{number(), number()} : d;
    const int sign = written::orientation(a, b, c);
    ASSERT_EQ(sign, sgn(exact_area(a, b, c)));
    zeros += sign == 0;
  }
  EXPECT_GT(zeros, 5000);
}

TEST(WrittenCircle, SaysWhatTheDecimalsSay) {
  std::mt19937_64 engine(3);
  int zeros = 0;
  for (int k = 0; k < 5000; ++k) {
    const int places = static_cast<int>(engine() % 4);
    const int r = static_cast<int>(engine() % 3) + 1;
    const auto at = [&](int x, int y) {
      return Point{written::sum(700.3, written::number(x * r, places)),
                   written::sum(5.4e6, written::number(y * r, places))};
    };
    Point p[4];
    const int ring[12][2] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                             {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
    int step = static_cast<int>(engine() % 4);
    for (Point& q : p) {
      q = at(ring[step % 12][0], ring[step % 12][1]);
      step += 1 + static_cast<int>(engine() % 3);
    }
    if (k % 2 == 0) p[3].x = std::nextafter(p[3].x, k % 4 == 0 ? 1e9 : -1e9);
    const ExactPoint a(p[0]), b(p[1]), c(p[2]), d(p[3]);
    const Rational ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
    const Rational det = (ax * ax + ay * ay) * (bx * cy - by * cx) - (bx * bx + by * by) * (ax * cy - ay * cx) +
                         (cx * cx + cy * cy) * (ax * by - ay * bx);
    ASSERT_EQ(written::side_of_circle(p[0], p[1], p[2], p[3]), sgn(det));
    zeros += sgn(det) == 0;
  }
  EXPECT_GT(zeros, 2000);
}

}  // namespace
}  // namespace taut
