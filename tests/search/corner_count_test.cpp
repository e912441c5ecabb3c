#include <taut/search/corner_count.h>

#include <gtest/gtest.h>

#include <vector>

namespace taut {
namespace {

std::size_t corners(const std::vector<Point>& chain) { return corner_count(chain); }

TEST(CornerCount, CountsBendsNotPoints) {
  EXPECT_EQ(corners({}), 0u);
  EXPECT_EQ(corners({{1, 1}}), 0u);
  EXPECT_EQ(corners({{0, 0}, {4, 4}}), 0u);
  EXPECT_EQ(corners({{0, 0}, {1, 1}, {3, 3}, {4, 4}}), 0u) << "straight on";
  EXPECT_EQ(corners({{0, 0}, {2, 0}, {2, 0}, {2, 3}}), 1u) << "a repeated point";
  EXPECT_EQ(corners({{0, 0}, {2, 0}, {2, 3}, {2, 4}, {5, 4}}), 2u);
}

TEST(CornerCount, CountsTurningBack) {
  EXPECT_EQ(corners({{0, 0}, {2, 0}, {1, 0}}), 1u);
  EXPECT_EQ(corners({{0, 0}, {2, 0}, {0, 0}}), 1u);
}

TEST(CornerCount, IsDecidedByWhatWasWritten) {
  EXPECT_EQ(corners({{0, 0.6}, {0.8, 1.1}, {4, 3.1}}), 0u) << "in line as decimals, not as doubles";
  EXPECT_EQ(corners({{0, 0.6}, {0.8, 1.1000000000001}, {4, 3.1}}), 1u);
}

}  // namespace
}  // namespace taut
