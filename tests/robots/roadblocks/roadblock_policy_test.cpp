// Decisions among roadblocks, against all outcomes driven.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/drivers.h>
#include <taut/robots/roadblocks/roadblock_map_generator.h>

namespace taut::roadblocks {
namespace {

struct Driven {
  double mean = 0, worst = 0;  // steps; the worst of those with a way
};

double probability(const Course& course, RoadblockSet open) {
  double p = 1;
  for (std::size_t i = 0; i < course.roadblocks.size(); ++i)
    p *= (open >> i) & 1 ? course.roadblocks[i].open_probability : 1 - course.roadblocks[i].open_probability;
  return p;
}

/// Every outcome driven.
Driven all_outcomes(LatticePlanner& planner, DriverKind kind, Aim aim) {
  Driven driven;
  const Course& course = planner.course();
  for (RoadblockSet open = 0; open < RoadblockSet{1} << course.roadblocks.size(); ++open) {
    const Drive run = drive(course, open, *make_driver(kind, planner, open, aim), WallReading::points);
    driven.mean += probability(course, open) * static_cast<double>(run.controls.size());
    if (run.outcome == Outcome::reached)
      driven.worst = std::max(driven.worst, static_cast<double>(run.controls.size()));
  }
  return driven;
}

class GeneratedPolicy : public testing::TestWithParam<std::uint64_t> {};

TEST_P(GeneratedPolicy, KeepsItsPromiseOverAllOutcomes) {
  const RoadblockMap map = generate_roadblock_map({31, 31, 3, 0, GetParam()});
  const Pose start{map.course.start.x, map.course.start.y, 0};
  LatticePlanner planner(map.course, WallReading::points);
  const auto expected = RoadblockPolicy(planner, Aim::expected).choose(start, 0, 0);
  ASSERT_TRUE(expected.exact);
  const Driven ours = all_outcomes(planner, DriverKind::policy, Aim::expected);
  EXPECT_NEAR(ours.mean, expected.value, 1e-6);
  const auto worst = RoadblockPolicy(planner, Aim::worst).choose(start, 0, 0);
  ASSERT_TRUE(worst.exact);
  const Driven careful = all_outcomes(planner, DriverKind::policy, Aim::worst);
  EXPECT_LE(careful.worst, worst.value);
  for (const DriverKind kind : {DriverKind::optimist, DriverKind::pessimist}) {
    const Driven other = all_outcomes(planner, kind, Aim::expected);
    EXPECT_LE(careful.worst, other.worst) << name(kind);
    EXPECT_LE(ours.mean, other.mean + 1e-6) << name(kind);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, GeneratedPolicy, testing::Values(2, 5, 9, 12, 15, 23),
                         [](const auto& seed) { return "Seed" + std::to_string(seed.param); });

/// Two lanes to the goal: the short one with a roadblock far inside, the long one open.
RoadblockMap two_lanes(const std::string& p) {
  std::vector<std::string> rows(22, "#" + std::string(48, '.') + "#");
  rows.front() = rows.back() = std::string(50, '#');
  for (std::size_t y = 1; y < 12; ++y)
    for (std::size_t x = 10; x < 40; ++x)
      if (y < 4 || y > 5) rows[y][x] = '#';
  rows[4][30] = 'A';
  std::string text = "start 5 5\ngoal 46 5\nroadblock A 31 5 " + p + "\ngrid 50 22\n";
  for (const std::string& row : rows) text += row + "\n";
  return read_roadblock_map(text);
}

TEST(RoadblockPolicy, TriesTheLaneWhenItIsLikelyToBeOpenAndGoesAroundWhenNot) {
  const auto steps = [](const std::string& p, Aim aim) {
    const RoadblockMap map = two_lanes(p);
    LatticePlanner planner(map.course, WallReading::points);
    return drive(map.course, 1, *make_driver(DriverKind::policy, planner, 0, aim), WallReading::points).controls.size();
  };
  const std::size_t through = steps("0.99", Aim::expected), around = steps("0.05", Aim::expected);
  EXPECT_LT(through, around);
  EXPECT_EQ(steps("0.99", Aim::worst), around) << "probabilities do not matter to the careful";
}

TEST(RoadblockPolicy, PromisesSomethingBetweenTheWaysOpenAndClosed) {
  const RoadblockMap map = two_lanes("0.5");
  LatticePlanner planner(map.course, WallReading::points);
  const Pose start{5, 5, 0};
  const double open = static_cast<double>(planner.plan(start, 0)->controls.size());
  const double closed = static_cast<double>(planner.plan(start, 1)->controls.size());
  const auto choice = RoadblockPolicy(planner, Aim::expected).choose(start, 0, 0);
  EXPECT_GE(choice.value, open);
  EXPECT_LE(choice.value, closed);
  EXPECT_EQ(RoadblockPolicy(planner, Aim::worst).choose(start, 0, 0).value, closed);
}

TEST(RoadblockPolicy, SaysWhenItsBudgetDidNotSuffice) {
  const RoadblockMap map = generate_roadblock_map({31, 31, 3, 0, 5});
  LatticePlanner planner(map.course, WallReading::points);
  const auto choice =
      RoadblockPolicy(planner, Aim::expected, 2).choose({map.course.start.x, map.course.start.y, 0}, 0, 0);
  EXPECT_FALSE(choice.exact);
  EXPECT_NE(choice.plan, nullptr);
}

}  // namespace
}  // namespace taut::roadblocks
