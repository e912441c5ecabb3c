#include <taut/geometry/length.h>

#include <gmpxx.h>
#include <gtest/gtest.h>
#include <mpfr.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace taut {
namespace {

using Legs = std::vector<Segment>;
using Order = std::strong_ordering;

/// A leg of squared length dx^2 + dy^2, laid somewhere.
Segment leg(double dx, double dy, Point from = {3, -7}) { return {from, {from.x + dx, from.y + dy}}; }

Length length_of(const Legs& legs) {
  Length sum;
  for (const Segment& s : legs) sum.add(s.a, s.b);
  return sum;
}

/// An independent second opinion: both sums with 3000 bits, straight from the coordinates. 0 means equal to 2900 bits.
class Reference {
 public:
  explicit Reference(const Legs& legs) {
    mpfr_inits2(3000, sum_, dx_, dy_, static_cast<mpfr_ptr>(nullptr));
    mpfr_set_zero(sum_, 1);
    for (const Segment& s : legs) {
      mpfr_set_d(dx_, s.a.x, MPFR_RNDN);
      mpfr_sub_d(dx_, dx_, s.b.x, MPFR_RNDN);
      mpfr_set_d(dy_, s.a.y, MPFR_RNDN);
      mpfr_sub_d(dy_, dy_, s.b.y, MPFR_RNDN);
      mpfr_hypot(dx_, dx_, dy_, MPFR_RNDN);
      mpfr_add(sum_, sum_, dx_, MPFR_RNDN);
    }
  }
  ~Reference() { mpfr_clears(sum_, dx_, dy_, static_cast<mpfr_ptr>(nullptr)); }
  Reference(const Reference&) = delete;

  int compare(const Reference& other) const {
    if (mpfr_eq(sum_, other.sum_, 2900)) return 0;
    return mpfr_cmp(sum_, other.sum_) > 0 ? 1 : -1;
  }
  bool is_in(Interval i) const { return mpfr_cmp_d(sum_, i.lo) >= 0 && mpfr_cmp_d(sum_, i.hi) <= 0; }
  double nearest() const { return mpfr_get_d(sum_, MPFR_RNDN); }
  std::string decimals(int places) const {
    char* text = nullptr;
    mpfr_asprintf(&text, "%.*RNf", places, sum_);
    std::string result = text;
    mpfr_free_str(text);
    return result;
  }

 private:
  mpfr_t sum_, dx_, dy_;
};

int sign(Order order) { return order < 0 ? -1 : order > 0 ? 1 : 0; }

// ---- distance_interval

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

// ---- comparison

TEST(LengthComparison, FindsThatTwoRootsAddUpToAThird) {
  // sqrt(2) + sqrt(8) = sqrt(18)
  EXPECT_EQ(compare_lengths(Legs{leg(1, 1), leg(2, 2)}, Legs{leg(3, 3)}), Order::equal);
  EXPECT_EQ(compare_lengths(Legs{leg(1, 1), leg(2, 2)}, Legs{leg(3, -3, {0.5, 0.25})}), Order::equal);
  // sqrt(5) + sqrt(20) + sqrt(2) = sqrt(45) + sqrt(2)
  EXPECT_EQ(compare_lengths(Legs{leg(1, 2), leg(4, 2), leg(1, 1)}, Legs{leg(1, -1), leg(-6, 3)}), Order::equal);
}

TEST(LengthComparison, TakesRationalLengthsTogether) {
  EXPECT_EQ(compare_lengths(Legs{leg(3, 4), leg(5, 12)}, Legs{leg(18, 0)}), Order::equal);
  EXPECT_EQ(compare_lengths(Legs{leg(0.75, 1)}, Legs{leg(0, 0.5), leg(0.75, 0)}), Order::equal);
  EXPECT_EQ(compare_lengths(Legs{leg(3, 4), leg(1, 1)}, Legs{leg(1, 1), leg(4, 3), leg(0x1p-40, 0, {0, 0})}),
            Order::less);
}

TEST(LengthComparison, SplitsALineOfDecimalPointsExactly) {
  // 0.1, 0.3, 0.7 are not what they look like, but the parts of a line still add up to it.
  EXPECT_EQ(compare_lengths(Legs{{{0.1, 5}, {0.3, 5}}, {{0.3, 5}, {0.7, 5}}}, Legs{{{0.7, 5}, {0.1, 5}}}),
            Order::equal);
  // On the diagonal likewise, by way of big rationals.
  EXPECT_EQ(compare_lengths(Legs{{{0.1, 0.1}, {0.3, 0.3}}, {{0.3, 0.3}, {0.7, 0.7}}}, Legs{{{0.7, 0.7}, {0.1, 0.1}}}),
            Order::equal);
  EXPECT_NE(compare_lengths(Legs{{{0, 0}, {0.1, 0}}, {{0, 0}, {0.2, 0}}}, Legs{{{0, 0}, {0.3, 0}}}), Order::equal);
}

TEST(LengthComparison, IgnoresTheOrderOfLegsAndTheirDirection) {
  EXPECT_EQ(compare_lengths(Legs{leg(1, 2), leg(0.1, 0.7, {0, 0}), leg(7, 7)},
                            Legs{leg(-7, 7), leg(2, 1), {{0.1, 0.7}, {0, 0}}}),
            Order::equal);
}

TEST(LengthComparison, IgnoresLegsOfLengthZero) {
  EXPECT_EQ(compare_lengths(Legs{}, Legs{leg(0, 0)}), Order::equal);
  EXPECT_EQ(compare_lengths(Legs{}, Legs{leg(0, 5e-324, {0, 0})}), Order::less);
  EXPECT_EQ(compare_lengths(Legs{leg(1, 1), leg(0, 0)}, Legs{leg(1, 1)}), Order::equal);
}

TEST(LengthComparison, SeparatesNeighbouringDoubles) {
  const double more = std::nextafter(0.3, 1);
  EXPECT_EQ(compare_lengths(Legs{{{0, 0}, {0.7, 0.3}}}, Legs{{{0, 0}, {0.7, more}}}), Order::less);
  EXPECT_EQ(compare_lengths(Legs{{{0, 0}, {1e75, 0}}}, Legs{{{0, 0}, {1e75, 5e-324}}}), Order::less);
  EXPECT_EQ(compare_lengths(Legs{{{0, 0}, {1e75, 5e-324}}}, Legs{{{0, 0}, {0, 1e75}}}), Order::greater);
}

TEST(LengthComparison, SeparatesTheClassicNearTies) {
  const auto by_squares = [](std::vector<std::pair<int, int>> a, std::vector<std::pair<int, int>> b) {
    Legs left, right;
    for (const auto& [dx, dy] : a) left.push_back(leg(dx, dy));
    for (const auto& [dx, dy] : b) right.push_back(leg(dx, dy));
    const int expected = Reference(left).compare(Reference(right));
    EXPECT_NE(expected, 0);
    EXPECT_EQ(sign(compare_lengths(left, right)), expected);
    EXPECT_EQ(sign(compare_lengths(right, left)), -expected);
  };
  by_squares({{1, 3}, {1, 4}}, {{1, 2}, {2, 4}});  // sqrt(10) + sqrt(17), sqrt(5) + sqrt(20)
  by_squares({{1, 3}, {3, 3}}, {{1, 2}, {4, 3}});
  by_squares({{1, 1}, {1, 2}, {2, 3}}, {{1, 3}, {1, 1}, {2, 2}});
}

/// All sums of three distances on the lattice: pairs of neighbours less than `closer` and more than `apart` from each other.
std::vector<std::pair<Legs, Legs>> close_sums_of_three(int reach, long double apart, long double closer) {
  std::map<int, Segment> by_square;
  for (int x = 1; x <= reach; ++x)
    for (int y = 0; y <= x; ++y) by_square.try_emplace(x * x + y * y, leg(x, y, {0, 0}));
  struct Sum {
    long double value;
    std::array<int, 3> squares;
  };
  std::vector<Sum> sums;
  const auto root = [](auto i) { return std::sqrt(static_cast<long double>(i->first)); };
  for (auto i = by_square.begin(); i != by_square.end(); ++i)
    for (auto j = i; j != by_square.end(); ++j)
      for (auto k = j; k != by_square.end(); ++k)
        sums.push_back({root(i) + root(j) + root(k), {i->first, j->first, k->first}});
  std::sort(sums.begin(), sums.end(), [](const Sum& a, const Sum& b) { return a.value < b.value; });
  const auto legs = [&](const Sum& sum) {
    Legs result;
    for (const int square : sum.squares) result.push_back(by_square.at(square));
    return result;
  };
  std::vector<std::pair<Legs, Legs>> pairs;
  for (std::size_t i = 0; i + 1 < sums.size(); ++i) {
    const long double gap = sums[i + 1].value - sums[i].value;
    if (apart <= gap && gap < closer) pairs.emplace_back(legs(sums[i]), legs(sums[i + 1]));
  }
  return pairs;
}

TEST(LengthComparison, FindsTheTiesAmongSumsOfThreeLatticeDistances) {
  const auto pairs = close_sums_of_three(12, 0, 1e-17L);
  EXPECT_GT(pairs.size(), 1000u);
  for (const auto& [a, b] : pairs) {
    ASSERT_EQ(Reference(a).compare(Reference(b)), 0);
    ASSERT_EQ(compare_lengths(a, b), Order::equal);
    ASSERT_EQ(length_of(a), length_of(b));
  }
}

TEST(LengthComparison, AgreesWith3000BitsOnTheClosestSumsOfThreeLatticeDistances) {
  const auto pairs = close_sums_of_three(14, 1e-17L, 1e-6L);
  EXPECT_GT(pairs.size(), 100u);
  for (const auto& [a, b] : pairs) {
    const int expected = Reference(a).compare(Reference(b));
    ASSERT_NE(expected, 0);
    ASSERT_EQ(sign(compare_lengths(a, b)), expected);
    ASSERT_EQ(sign(compare_lengths(b, a)), -expected);
  }
}

Segment leg_of_square(int square) {
  for (int x = 0;; ++x)
    for (int y = 0; y <= x; ++y)
      if (x * x + y * y == square) return leg(x, y, {0, 0});
}

TEST(LengthComparison, SeparatesSumsThatAgreeToSixteenDigits) {
  // The closest of all sums of three distances between lattice points at most 52 apart: 5 to 13 times 10^-15 between two sums above 90.
  constexpr int kSquares[][6] = {
      {613, 2389, 3922, 788, 1250, 5305}, {724, 1000, 1921, 362, 832, 2969},    {493, 2664, 4325, 922, 2344, 3697},
      {730, 1370, 1469, 272, 392, 4365},  {488, 1037, 1637, 45, 1282, 2729},    {1109, 1385, 2525, 738, 1733, 2701},
      {89, 1490, 2753, 116, 1378, 2768},  {1213, 2237, 2501, 1069, 2053, 2930},
  };
  for (const auto& squares : kSquares) {
    Legs a, b;
    for (int i = 0; i < 3; ++i) a.push_back(leg_of_square(squares[i]));
    for (int i = 3; i < 6; ++i) b.push_back(leg_of_square(squares[i]));
    EXPECT_EQ(length_of(a).decimals(12), length_of(b).decimals(12));
    EXPECT_LE(length_of(a).interval().lo, length_of(b).interval().hi);
    EXPECT_LE(length_of(b).interval().lo, length_of(a).interval().hi);
    const int expected = Reference(a).compare(Reference(b));
    EXPECT_NE(expected, 0);
    EXPECT_EQ(sign(compare_lengths(a, b)), expected);
    EXPECT_EQ(sign(compare_lengths(b, a)), -expected);
  }
}

/// A number close to another one by more than double-double: (sqrt(m^2 + 1) - m) for huge m against what it is nearly.
TEST(LengthComparison, GoesBeyondDoubleDoubleWhereItMust) {
  const double m = 0x1p60;
  // sqrt(m^2 + 1) - m is 2^-61 (1 - 2^-122 ...): against a leg of exactly 2^-61.
  const Legs a{{{0, 0}, {m, 1}}}, b{{{0, 0}, {m, 0}}, {{0, 0}, {0x1p-61, 0}}};
  EXPECT_EQ(compare_lengths(a, b), Order::less);
  EXPECT_EQ(compare_lengths(b, a), Order::greater);
}

Legs any_legs(int count, int range, double unit) {
  Legs legs;
  const auto coordinate = [&] { return *rc::gen::inRange(0, range) * unit; };
  for (int i = 0; i < count; ++i) {
    const double ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
    legs.push_back({{ax, ay}, {bx, by}});
  }
  return legs;
}

RC_GTEST_PROP(LengthComparison, AgreesWith3000BitsOnSmallLattices, ()) {
  const double unit = *rc::gen::element(1.0, 0.1, 0x1p-30, 1e70, 1e-140, 1e-310);
  const Legs a = any_legs(*rc::gen::inRange(0, 6), 5, unit), b = any_legs(*rc::gen::inRange(0, 6), 5, unit);
  const int expected = Reference(a).compare(Reference(b));
  RC_ASSERT(sign(compare_lengths(a, b)) == expected);
  RC_ASSERT(sign(compare_lengths(b, a)) == -expected);
  RC_ASSERT(sign(length_of(a) <=> length_of(b)) == expected);
}

RC_GTEST_PROP(LengthComparison, IsTransitive, ()) {
  std::vector<Length> lengths;
  for (int i = 0; i < 3; ++i) lengths.push_back(length_of(any_legs(*rc::gen::inRange(1, 4), 4, 1)));
  std::sort(lengths.begin(), lengths.end());
  RC_ASSERT(lengths[0] <= lengths[1] && lengths[1] <= lengths[2] && lengths[0] <= lengths[2]);
  if (lengths[0] == lengths[1] && lengths[1] == lengths[2]) RC_ASSERT(lengths[0] == lengths[2]);
}

RC_GTEST_PROP(LengthComparison, FindsAnyShuffledSplitOfALegEqual, ()) {
  // k steps of (dx, dy) in one leg, in two, or with others in between.
  const Legs others = any_legs(*rc::gen::inRange(0, 30), 40, *rc::gen::element(1.0, 0.1));
  const int dx = *rc::gen::inRange(1, 9), dy = *rc::gen::inRange(0, 9), k = *rc::gen::inRange(2, 9),
            j = *rc::gen::inRange(1, k);
  Legs a = others, b(others.rbegin(), others.rend());
  a.push_back(leg(k * dx, k * dy));
  b.insert(b.begin(), leg(j * dx, j * dy));
  b.push_back(leg((k - j) * dy, (k - j) * dx));
  RC_ASSERT(sign(compare_lengths(a, b)) == 0);
  b.back().b.x = std::nextafter(b.back().b.x, 1e9);
  RC_ASSERT(sign(compare_lengths(a, b)) == -1);
}

// ---- Length

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

}  // namespace
}  // namespace taut
