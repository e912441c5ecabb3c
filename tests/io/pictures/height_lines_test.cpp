// Contour lines against heights that are known everywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <taut/io/pictures/detail/height_lines.h>

namespace taut::detail {
namespace {

struct End {
  double x, y;
  friend auto operator<=>(const End&, const End&) = default;
};

/// Both ends of each piece, one after the other.
std::vector<End> ends_of(const std::string& path) {
  std::string words = path;
  for (char& c : words)
    if (c == 'M' || c == 'L') c = ' ';
  std::istringstream in(words);
  std::vector<End> ends;
  for (End e{}; in >> e.x >> e.y;) ends.push_back(e);
  return ends;
}

Heights drawn(int columns, int rows, double (*height)(double, double)) {
  Heights heights{columns, rows, {}};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) heights.of.push_back(height(i, j));
  return heights;
}

TEST(HeightLines, AreStraightOnASlope) {
  const Heights slope = drawn(5, 4, [](double x, double) { return 10 * x; });
  const std::vector<End> ends = ends_of(height_line(slope, 25, 0.5, 1, 2));
  EXPECT_EQ(ends.size(), 6U) << "three rows of squares";
  for (const End& e : ends) EXPECT_DOUBLE_EQ(e.x, 1 + 0.5 * 2.5);
  EXPECT_EQ(height_line(slope, 41, 1, 0, 0), "");
}

TEST(HeightLines, GoAroundAHillAndAreClosed) {
  const Heights hill = drawn(21, 21, [](double x, double y) { return std::hypot(x - 10.3, y - 9.8); });
  std::map<End, int> met;
  for (const End& e : ends_of(height_line(hill, 6, 1, 0, 0))) {
    ++met[e];
    EXPECT_NEAR(std::hypot(e.x - 10.3, e.y - 9.8), 6, 0.05);
  }
  EXPECT_GT(met.size(), 30U);
  for (const auto& [end, times] : met) EXPECT_EQ(times, 2) << end.x << " " << end.y;
}

TEST(HeightLines, SplitASaddleByItsMiddle) {
  const Heights low{2, 2, {1, 0, 0, 1}}, high{2, 2, {1, 0.8, 0.8, 1}};
  // Its middle is below 0.6, so the two high corners are apart; of the other one it is above 0.85.
  EXPECT_EQ(height_line(low, 0.6, 1, 0, 0), "M0.40 0.00L0.00 0.40M0.60 1.00L1.00 0.60");
  EXPECT_EQ(height_line(high, 0.85, 1, 0, 0), "M0.75 0.00L1.00 0.25M0.25 1.00L0.00 0.75");
}

TEST(HeightLines, StopWhereThereAreNoHeights) {
  Heights slope = drawn(5, 4, [](double x, double) { return 10 * x; });
  slope.of[1 * 5 + 2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ends_of(height_line(slope, 25, 1, 0, 0)).size(), 2U) << "two of the three squares have that corner";
}

TEST(HeightLines, HaveARoundInterval) {
  EXPECT_DOUBLE_EQ(contour_interval(160), 20);
  EXPECT_DOUBLE_EQ(contour_interval(159), 10);
  EXPECT_DOUBLE_EQ(contour_interval(9), 1);
  EXPECT_DOUBLE_EQ(contour_interval(40), 5);
}

}  // namespace
}  // namespace taut::detail
