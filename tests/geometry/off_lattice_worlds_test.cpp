// Worlds on no lattice: decimals of so many places that no integers hold them, mixed with computed numbers.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/exact_arrangement.h>
#include <support/small_world.h>
#include <taut/geometry/number_lattice.h>
#include <taut/geometry/rounding.h>
#include <taut/search/no_path.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

namespace taut {
namespace {

int worlds(int usual) {
  const char* asked = std::getenv("TAUT_RANDOM_WORLDS");
  return asked ? std::atoi(asked) : usual;
}

/// What a number means, by the C library's digits and nothing of the product: fifteen digits that read back, or itself.
Rational meaning(double v) {
  char text[64];
  std::snprintf(text, sizeof text, "%.14e", v);
  if (std::strtod(text, nullptr) != v) return Rational(v);
  const std::string digits(text);
  const std::size_t e = digits.find('e'), dot = digits.find('.');
  const int exponent = std::atoi(digits.c_str() + e + 1) - static_cast<int>(e - dot - 1);
  const Integer scale = power(10, static_cast<unsigned>(std::abs(exponent)));
  const Rational whole(Integer(digits.substr(0, dot) + digits.substr(dot + 1, e - dot - 1)));
  return exponent < 0 ? Rational(whole / scale) : Rational(whole * scale);
}

test::RationalPoint meaning(Point p) { return {meaning(p.x), meaning(p.y)}; }

/// Walls between the crossings of some columns and rows whose places are decimals or computed, and between points that
/// lie exactly in the middle of such walls.
class OffLattice {
 public:
  explicit OffLattice(unsigned seed) : engine_(seed), xs_(places(between(3, 7))), ys_(places(between(3, 7))) {
    for (int n = between(2, 7); n > 0; --n) {
      const Segment wall{place(), place()};
      if (wall.a != wall.b) walls_.push_back(wall);
    }
    start = place();
    goal = place();
  }

  World world() const {
    return World(test::SmallWorld{.walls = walls_, .area = test::box_ring(0, 0, xs_.back(), ys_.back())}.parts())
        .with_ends(start, goal);
  }

  std::optional<double> length() const {
    std::vector<test::RationalWall> exact;
    for (const Segment& s : walls_) exact.push_back({meaning(s.a), meaning(s.b)});
    return test::arrangement_path(meaning(xs_.back()), meaning(ys_.back()), exact, meaning(start), meaning(goal));
  }

  std::string text() const {
    std::string s;
    const auto add = [&](double v) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.17g ", v);
      s += digits;
    };
    for (const char* word : {"boundary 0 0 ", "\nstart ", "\ngoal "}) {
      const Point p = word[1] == 's' ? start : word[1] == 'g' ? goal : Point{xs_.back(), ys_.back()};
      s += word;
      add(p.x);
      add(p.y);
    }
    for (const Segment& w : walls_) {
      s += "\n";
      for (const double v : {w.a.x, w.a.y, w.b.x, w.b.y}) add(v);
    }
    return s;
  }

  Point start, goal;

 private:
  int between(int a, int b) { return a + static_cast<int>(engine_() % static_cast<unsigned>(b - a + 1)); }
  double unit() { return static_cast<double>(engine_()) / 4294967296.0; }

  /// 0 and then about one apart: whole, decimals with one to thirteen places, or computed.
  std::vector<double> places(int count) {
    std::vector<double> result{0};
    for (int i = 1; i <= count; ++i) {
      char text[32];
      std::snprintf(text, sizeof text, "%.*f", between(1, 13), i + (unit() - 0.5) / 2);
      const int kind = between(0, 3);
      result.push_back(kind == 0 ? i : kind == 1 ? i + unit() / 3 : std::strtod(text, nullptr));
    }
    return result;
  }

  Point place() {
    if (!walls_.empty() && between(0, 2) == 0) {
      const auto [a, b] = walls_[static_cast<std::size_t>(between(0, static_cast<int>(walls_.size()) - 1))];
      const Point middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
      if (2 * meaning(middle.x) == meaning(a.x) + meaning(b.x) && 2 * meaning(middle.y) == meaning(a.y) + meaning(b.y))
        return middle;
    }
    return {xs_[static_cast<std::size_t>(between(0, static_cast<int>(xs_.size()) - 1))],
            ys_[static_cast<std::size_t>(between(0, static_cast<int>(ys_.size()) - 1))]};
  }

  std::mt19937 engine_;
  std::vector<double> xs_, ys_;
  std::vector<Segment> walls_;
};

TEST(OffLatticeWorld, HasTheShortestPathsOfTheExactArrangement) {
  int none = 0, off = 0;
  const int count = worlds(300);
  for (int k = 0; k < count; ++k) {
    const OffLattice drawn(static_cast<unsigned>(k) + 1);
    const World world = drawn.world();
    const FreeSpace space(world);
    off += !number_lattice(world);
    const auto path = shortest_path(space, drawn.start, drawn.goal);
    const auto exact = drawn.length();
    ASSERT_EQ(path.has_value(), exact.has_value()) << k << "\n" << drawn.text();
    if (!path) {
      ++none;
      ASSERT_TRUE(NoPath(space).holds(drawn.start, world.goal())) << k << ": ends on walls and corners are sure\n"
                                                                  << drawn.text();
      continue;
    }
    ASSERT_NEAR(path->length.value(), *exact, 1e-9 * (1 + *exact)) << k << "\n" << drawn.text();
    ASSERT_TRUE(verify(*path, space, drawn.start, world.goal()).valid) << k << "\n" << drawn.text();
  }
  EXPECT_GT(off, count / 2) << "most are on no lattice";
  EXPECT_GT(none, count / 30);
}

TEST(RoundingBound, IsNothingWhereNoCrossingIsRounded) {
  const FreeSpace space = test::SmallWorld{.walls = {{{1, 1}, {5, 5}}, {{1, 5}, {5, 1}}}}.space();
  EXPECT_EQ(rounding_bound(space), 0);
  EXPECT_TRUE(is_sure(space, {3, 3.0000000000000004}));
}

TEST(RoundingBound, LeavesEndsBesideBentWallsUnsure) {
  const FreeSpace space = test::SmallWorld{.walls = {{{1, 1}, {8, 4}}, {{1, 5}, {7, 0}}}}.space();
  const double d = rounding_bound(space);
  EXPECT_GT(d, 0);
  EXPECT_LT(d, 1e-11);
  EXPECT_TRUE(is_sure(space, {1, 1})) << "a wall's end lies on it";
  EXPECT_TRUE(is_sure(space, {3, 7}));
  EXPECT_FALSE(is_sure(space, {1, 1 + d})) << "beside the end, on which side of what goes on from there?";
  EXPECT_TRUE(is_sure(space, {1, 1 + 4 * d}));
}

TEST(RoundingBound, IsSureBesideWhatIsWhereItWasWritten) {
  const std::vector<Segment> walls{{{1, 1}, {8, 4}}, {{1, 5}, {7, 0}}, {{8, 8}, {9.5, 8.7}}};
  const FreeSpace space = test::SmallWorld{.walls = walls, .solids = {{{2, 7}, {4, 7.3}, {3, 9}}}}.space();
  const double d = rounding_bound(space);
  EXPECT_TRUE(is_sure(space, {9.5, 8.7 + d})) << "a wall that meets none";
  EXPECT_TRUE(is_sure(space, {4 + d, 7.3})) << "a corner of a solid";
  EXPECT_TRUE(is_sure(space, {10 - d, 5})) << "a side of the boundary";
  EXPECT_FALSE(is_sure(space, {8, 4 + d})) << "a wall that bends";
}

}  // namespace
}  // namespace taut
