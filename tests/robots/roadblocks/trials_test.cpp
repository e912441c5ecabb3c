// Which of the whole policies is followed: judged by drives in the same worlds.
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include <taut/robots/roadblocks/detail/trials.h>

namespace taut::roadblocks::detail {
namespace {

/// By turns so much less and more.
Steps around(double mean, double by, std::size_t count) {
  Steps steps;
  for (std::size_t k = 0; k < count; ++k) steps.push_back(k % 2 == 0 ? mean - by : mean + by);
  return steps;
}

TEST(Trials, TakeWhatNeedsFewerStepsByTwoStandardErrors) {
  const Steps base(100, 500);
  EXPECT_TRUE(is_better(Aim::expected, around(470, 100, 100), base, 100)) << "30 less, and an error of 10";
  EXPECT_FALSE(is_better(Aim::expected, around(485, 100, 100), base, 100)) << "15 less";
  EXPECT_FALSE(is_better(Aim::expected, around(530, 100, 100), base, 100));
  EXPECT_FALSE(is_better(Aim::expected, base, base, 100));
  EXPECT_TRUE(is_better(Aim::expected, Steps(100, 499), base, 100)) << "less in every world";
}

TEST(Trials, AskWhatAsManyDrivesAsHaveAWayWillShow) {
  const Steps base(400, 500), bold = around(470, 100, 400);
  EXPECT_TRUE(is_better(Aim::expected, bold, base, 100));
  EXPECT_FALSE(is_better(Aim::expected, bold, base, 16)) << "an error of 25";
}

TEST(Trials, TakeForTheWorstWhatIsLongerInNoQuarter) {
  Steps base = around(500, 100, 40), bold = around(500, 30, 40);
  EXPECT_TRUE(is_better(Aim::worst, bold, base, 40)) << "530 and 600 in every quarter";
  EXPECT_FALSE(is_better(Aim::worst, base, bold, 40));
  EXPECT_FALSE(is_better(Aim::worst, base, base, 40));
  for (std::size_t k = 0; k < 10; ++k) base[k] = 400;
  EXPECT_FALSE(is_better(Aim::worst, bold, base, 40)) << "longer in the first quarter";
  for (std::size_t k = 0; k < 10; ++k) bold[k] = 400;
  EXPECT_TRUE(is_better(Aim::worst, bold, base, 40));
}

TEST(Trials, SayNothingOfThreeWorlds) {
  EXPECT_FALSE(is_better(Aim::expected, Steps(3, 100), Steps(3, 500), 3));
  EXPECT_FALSE(is_better(Aim::worst, {}, {}, 0));
}

}  // namespace
}  // namespace taut::roadblocks::detail
