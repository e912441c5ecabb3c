#include <taut/geometry/length.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "support/any_legs.h"

namespace taut::test {
namespace {

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

/// All sums of three distances on the lattice: pairs of neighbours less than `closer` and more than `apart` from each
/// other.
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
  // The closest of all sums of three distances between lattice points at most 52 apart: 5 to 13 times 10^-15 between
  // two sums above 90.
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

}  // namespace
}  // namespace taut::test
