#include <taut/robots/pursuit/online_pursuer.h>

#include <gtest/gtest.h>

#include <taut/io/worlds/read_chase_map.h>
#include <taut/robots/pursuit/chase.h>
#include <taut/robots/pursuit/chase_generator.h>
#include <taut/robots/pursuit/exact_planner.h>

namespace taut::pursuit {
namespace {

constexpr int kAll = 1'000'000;

ChaseResult chased(const ChaseMap& map, Clock clock, int horizon) {
  const ChaseMap ground = map.without_trajectory();
  const Unfolding unfolding(map, clock, horizon);
  OnlinePursuer pursuer(ground);
  return play(map, {clock, true, {}}, [&](CellIndex at, int now) { return pursuer.next(at, unfolding.at(now)); });
}

ChaseMap any_map(std::uint64_t seed) {
  return generate_chase_map({.x_size = 40,
                             .y_size = 30,
                             .seconds = 120,
                             .costly = seed % 2 == 0,
                             .buildings = 0.25,
                             .seed = seed,
                             .ground = seed % 3 == 0 ? ChaseGround::building : ChaseGround::town,
                             .inflation = 2});
}

TEST(OnlinePursuer, CostsWhatTheExactPlanDoesWhenItSeesEverything) {
  int caught = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const ChaseMap map = any_map(seed);
    for (const Clock clock : {Clock::zero, Clock::one}) {
      const ChasePlan plan = exact_plan(chase_of(map, clock));
      const ChaseResult result = chased(map, clock, kAll);
      ASSERT_EQ(result.end == ChaseEnd::caught, plan.status == SearchStatus::found) << seed;
      if (plan.status != SearchStatus::found) continue;
      ASSERT_EQ(result.cost, plan.cost) << seed;
      ++caught;
    }
  }
  EXPECT_GT(caught, 200);
}

TEST(OnlinePursuer, IsLegalNeverCheaperThanTheOptimumAndCatchesMostTargets) {
  int caught = 0, possible = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const ChaseMap map = any_map(seed);
    for (const int horizon : {0, 1, 5, 30}) {
      const ChasePlan plan = exact_plan(chase_of(map, Clock::zero));
      const ChaseResult result = chased(map, Clock::zero, horizon);
      ASSERT_TRUE(result.end == ChaseEnd::caught || result.end == ChaseEnd::escaped) << result.reason;
      possible += plan.status == SearchStatus::found;
      if (result.end != ChaseEnd::caught) continue;
      ++caught;
      ASSERT_EQ(plan.status, SearchStatus::found);
      ASSERT_GE(result.cost, plan.cost) << seed << " " << horizon;
    }
  }
  EXPECT_GT(10 * caught, 9 * possible) << caught << " of " << possible;
}

TEST(Unfolding, ShowsTheSecondsUpToTheHorizonByEitherClock) {
  const ChaseMap map = read_chase_map("N 1,4 C 5 R 1,1 T 1,2 1,3 1,4 M 1,1,1,1");
  const auto seconds = [&](Clock clock, int horizon, int now) {
    std::vector<int> all;
    for (const Meeting& m : Unfolding(map, clock, horizon).at(now).seen) all.push_back(m.second);
    return all;
  };
  EXPECT_EQ(seconds(Clock::zero, 0, 0), std::vector<int>({0}));
  EXPECT_EQ(seconds(Clock::one, 0, 0), std::vector<int>({}));
  EXPECT_EQ(seconds(Clock::one, 1, 0), std::vector<int>({1}));
  EXPECT_EQ(seconds(Clock::zero, 1, 1), std::vector<int>({1, 2}));
  EXPECT_EQ(seconds(Clock::zero, kAll, 1), std::vector<int>({1, 2}));
  EXPECT_EQ(seconds(Clock::zero, 0, 3), std::vector<int>({}));
}

TEST(OnlinePursuer, KnowsAMapWithoutTrajectory) {
  const ChaseMap map = any_map(1), ground = map.without_trajectory();
  EXPECT_EQ(ground.target(), std::vector<CellIndex>{map.start()});
  EXPECT_EQ(ground.costs(), map.costs());
}

// The target turns back: the robot heads for where it was going, then for where it is.
TEST(OnlinePursuer, ChasesATargetThatTurns) {
  const ChaseMap map =
      read_chase_map("N 1,9 C 5 R 1,9 T 1,1 1,2 1,3 1,2 1,1 1,1 1,1 1,1 1,1 1,1 1,1 M 1,1,1,1,1,1,1,1,1");
  const ChaseResult result = chased(map, Clock::zero, 0);
  EXPECT_EQ(result.end, ChaseEnd::caught);
  EXPECT_EQ(result.time, 8);
}

}  // namespace
}  // namespace taut::pursuit
