#include <gtest/gtest.h>

#include <vector>

#include <taut/search/corner_count.h>

namespace taut {
namespace {

std::size_t count(std::vector<Point> points, double uncertainty = 0) { return corner_count(points, uncertainty); }

TEST(CornerCount, CountsBendsNotPoints) {
  EXPECT_EQ(count({}), 0u);
  EXPECT_EQ(count({{1, 1}}), 0u);
  EXPECT_EQ(count({{0, 0}, {4, 4}}), 0u);
  EXPECT_EQ(count({{0, 0}, {1, 1}, {3, 3}, {4, 4}}), 0u) << "straight on";
  EXPECT_EQ(count({{0, 0}, {2, 0}, {2, 0}, {2, 3}}), 1u) << "a repeated point";
  EXPECT_EQ(count({{0, 0}, {2, 0}, {2, 3}, {2, 4}, {5, 4}}), 2u);
}

TEST(CornerCount, CountsTurningBack) {
  EXPECT_EQ(count({{0, 0}, {2, 0}, {1, 0}}), 1u);
  EXPECT_EQ(count({{0, 0}, {2, 0}, {0, 0}}), 1u);
}

TEST(CornerCount, IsDecidedByWhatWasWritten) {
  EXPECT_EQ(count({{0, 0.6}, {0.8, 1.1}, {4, 3.1}}), 0u) << "in line as decimals, not as doubles";
  EXPECT_EQ(count({{0, 0.6}, {0.8, 1.1000000000001}, {4, 3.1}}), 1u);
}

TEST(CornerCount, PassesOverBendsThatUncertaintyExplains) {
  const std::vector<Point> wavy{{0, 0}, {1, 1e-4}, {2, -1e-4}, {3, 0}, {3, 1}, {3 + 1e-4, 2}, {3, 3}};
  EXPECT_EQ(count(wavy, 1e-3), 1U);
  EXPECT_EQ(count(wavy, 1e-5), 5U);
}

TEST(CornerCount, HasPointsInNoOrderWhereTheyAreNearerThanTheyAreCertain) {
  EXPECT_EQ(count({{0, 0}, {1, 0}, {1 - 1e-5, 1e-5}, {2, 0}}, 1e-4), 0U);
}

TEST(CornerCount, DoesNotLoseABendThatComesLittleByLittle) {
  std::vector<Point> arc;
  for (int i = 0; i <= 1000; ++i) arc.push_back({i / 1000.0, i * i / 1e6});
  EXPECT_GE(count(arc, 1e-3), 5U);
}

}  // namespace
}  // namespace taut
