// Decisions among many roadblocks, by simulated drives.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/drivers.h>
#include <taut/robots/roadblocks/roadblock_map_generator.h>

#include "support/second_car.h"

namespace taut::roadblocks {
namespace {

constexpr WallReading kPoints = WallReading::points;

Pose start_of(const Course& course) { return {course.start.x, course.start.y, 0}; }

struct Total {
  int reached = 0;
  double steps = 0;
};

/// Every sample that the clairvoyant reaches is reached, and no other.
Total all_samples(const RoadblockMap& map, WallReading reading, Aim aim) {
  LatticePlanner planner(map.course, reading), knowing(map.course, reading);
  DrivePolicy policy(planner, aim);
  Total total;
  for (const Sample& sample : map.samples) {
    const auto driver = make_driver(policy, planner);
    const Drive run = drive(map.course, sample.open, *driver, reading);
    const auto bound = make_driver(DriverKind::clairvoyant, knowing, sample.open);
    EXPECT_EQ(run.outcome, drive(map.course, sample.open, *bound, reading).outcome) << sample.number;
    EXPECT_FALSE(test::replay(map.course, sample.open, run.controls, reading).collided) << sample.number;
    if (run.outcome != Outcome::reached) continue;
    ++total.reached;
    total.steps += static_cast<double>(run.controls.size());
  }
  return total;
}

TEST(RolloutPolicy, ReachesEverySampleThatHasAWayAmongSixteenRoadblocks) {
  const RoadblockMap map = generate_roadblock_map({50, 50, 16, 6, 203});
  EXPECT_GT(all_samples(map, kPoints, Aim::expected).reached, 0);
  EXPECT_GT(all_samples(map, kPoints, Aim::worst).reached, 0);
}

TEST(RolloutPolicy, NeedsFewerStepsThanTheOptimistWhereLooksPay) {
  const RoadblockMap map = generate_roadblock_map({50, 50, 16, 12, 203});
  LatticePlanner planner(map.course, kPoints);
  double optimist = 0;
  for (const Sample& sample : map.samples) {
    const auto driver = make_driver(DriverKind::optimist, planner);
    const Drive run = drive(map.course, sample.open, *driver, kPoints);
    if (run.outcome == Outcome::reached) optimist += static_cast<double>(run.controls.size());
  }
  EXPECT_LT(all_samples(map, kPoints, Aim::expected).steps, 0.95 * optimist);
}

/// Two lanes to the goal: the short one with roadblocks far inside, the long one open.
Course two_lanes(const std::string& p) {
  std::vector<std::string> rows(22, "#" + std::string(48, '.') + "#");
  rows.front() = rows.back() = std::string(50, '#');
  for (std::size_t y = 1; y < 12; ++y)
    for (std::size_t x = 10; x < 40; ++x)
      if (y < 4 || y > 5) rows[y][x] = '#';
  std::string text = "start 5 5\ngoal 46 5\n";
  for (std::size_t b = 0; b < 3; ++b) {
    rows[4][30 + b] = static_cast<char>('A' + b);
    text += "roadblock " + std::string(1, rows[4][30 + b]) + " " + std::to_string(31 + b) + " 5 " + p + "\n";
  }
  text += "grid 50 22\n";
  for (const std::string& row : rows) text += row + "\n";
  return read_roadblock_map(text).course;
}

TEST(RolloutPolicy, TriesADoorThatIsLikelyToBeOpenAndGoesAroundWhenNot) {
  using Look = RolloutPolicy::Look;
  const auto crossed = [](const std::string& p, Aim aim, Look look = Look::rollouts) {
    const Course course = two_lanes(p);
    LatticePlanner planner(course, kPoints);
    const auto choice = RolloutPolicy(planner, aim, look).choose(start_of(course), 0, 0);
    return crosses(start_of(course), *choice.plan, course.roadblocks[0], kPoints);
  };
  EXPECT_TRUE(crossed("0.99", Aim::expected));
  EXPECT_FALSE(crossed("0.4", Aim::expected)) << "three in series are open with 0.064";
  EXPECT_TRUE(crossed("0.99", Aim::expected, Look::uct));
  EXPECT_FALSE(crossed("0.4", Aim::expected, Look::uct));
  EXPECT_FALSE(crossed("0.99", Aim::worst)) << "a world with the door closed is among those drawn";
}

TEST(RolloutPolicy, GivesTheSameAnswersToTheSameQuestions) {
  const Course course = generate_roadblock_map({50, 50, 16, 0, 203}).course;
  LatticePlanner one(course, kPoints), other(course, kPoints);
  RolloutPolicy policy(one, Aim::expected);
  const auto choice = policy.choose(start_of(course), 0, 0);
  const auto again = policy.choose(start_of(course), 0, 0);
  EXPECT_EQ(again.plan, choice.plan);
  EXPECT_EQ(policy.decisions(), 1U);
  const auto elsewhere = RolloutPolicy(other, Aim::expected).choose(start_of(course), 0, 0);
  EXPECT_EQ(elsewhere.value, choice.value);
  EXPECT_EQ(elsewhere.plan->controls, choice.plan->controls);
}

TEST(RolloutPolicy, PlansOnceWhicheverRoadblockOfALaneIsClosed) {
  const Course course = two_lanes("0.5");
  LatticePlanner planner(course, kPoints);
  RolloutPolicy policy(planner, Aim::expected);
  const DrivePlan* plan = policy.hope(start_of(course), 0, 0b001).plan;
  const std::size_t searches = planner.plans();
  EXPECT_EQ(policy.hope(start_of(course), 0b001, 0b010).plan, plan);
  EXPECT_EQ(policy.hope(start_of(course), 0b011, 0b100).plan, plan);
  EXPECT_EQ(planner.plans(), searches);
  const Pose inside{26, 5.5, 0};  // the lane
  EXPECT_NE(policy.hope(inside, 0b001, 0b010).plan, nullptr);
}

// There a drive by estimates alone needs a tenth more steps than the optimist.
TEST(DrivePolicy, HopesWhereRealDrivesSayThatEstimatesMislead) {
  const Course course = generate_roadblock_map({50, 50, 12, 0, 7004, 3}).course;
  LatticePlanner planner(course, WallReading::squares);
  RolloutPolicy estimates(planner, Aim::expected);
  DrivePolicy policy(planner, Aim::expected);
  std::size_t steps = 0, hoped = 0;
  for (const RoadblockSet open : estimates.worlds(0, 12)) {
    steps += drive(course, open, *make_driver(policy, planner), WallReading::squares).controls.size();
    hoped += drive(course, open, *make_driver(DriverKind::optimist, planner), WallReading::squares).controls.size();
  }
  EXPECT_GT(hoped, 8 * 300U);
  EXPECT_LE(steps, hoped + 8);
}

TEST(DrivePolicy, IsExactAmongFewRoadblocksAndSaysWhenItIsNot) {
  const Course few = generate_roadblock_map({31, 31, 3, 0, 5}).course;
  LatticePlanner planner(few, kPoints), second(few, kPoints);
  const auto choice = DrivePolicy(planner, Aim::expected).choose(start_of(few), 0, 0);
  const auto exact = RoadblockPolicy(second, Aim::expected).choose(start_of(few), 0, 0);
  EXPECT_TRUE(choice.exact);
  EXPECT_EQ(choice.value, exact.value);
  EXPECT_EQ(choice.plan->controls, exact.plan->controls);
  const Course many = generate_roadblock_map({50, 50, 16, 0, 203}).course;
  LatticePlanner another(many, kPoints);
  EXPECT_FALSE(DrivePolicy(another, Aim::expected).choose(start_of(many), 0, 0).exact);
}

}  // namespace
}  // namespace taut::roadblocks
