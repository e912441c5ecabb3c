#include <taut/robots/pursuit/detail/block_way.h>

#include <gtest/gtest.h>

#include <taut/robots/pursuit/chase_generator.h>
#include <taut/robots/pursuit/detail/walk.h>
#include <taut/robots/pursuit/exact_planner.h>

namespace taut::pursuit {
namespace {

// The sides that are no multiples of the blocks leave cells at the far sides that belong to no block.
TEST(BlockWay, IsALegalWayInTimeOverBuildingsAndHills) {
  int found = 0;
  double ratio = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const ChaseMap map = generate_chase_map({.x_size = 83,
                                             .y_size = 107,
                                             .seconds = 60 + static_cast<int>(seed) * 5,
                                             .costly = seed % 3 != 0,
                                             .buildings = 0.1,
                                             .seed = seed,
                                             .ground = seed % 2 ? ChaseGround::building : ChaseGround::town,
                                             .inflation = 4});
    for (const int now : {0, 7}) {
      Chase chase = chase_of(map, Clock::zero);
      chase.now = now;
      const auto way = detail::way_over_blocks(chase, seed % 4 ? 3 : 5);
      if (!way) continue;
      ASSERT_LE(way->cells.size(), static_cast<std::size_t>(way->seconds) + 1);
      const ChasePlan plan = detail::plan_along(chase, way->cells, way->seconds);
      ASSERT_EQ(verify_plan(plan, chase), "") << seed;
      const ChasePlan best = exact_plan(chase);
      ASSERT_GE(plan.cost, best.cost);
      ratio += static_cast<double>(plan.cost) / static_cast<double>(best.cost);
      ++found;
    }
  }
  EXPECT_GT(found, 60);
  EXPECT_LT(ratio / found, 3);  // small maps have narrow doors
}

TEST(BlockWay, IsNoneWhereNoBlockIsFree) {
  ChaseMap::Parts parts{9, 9, std::vector<std::uint32_t>(81, 1), 0, {1, 1}, {{9, 9}, {9, 9}}, "", false, ""};
  for (std::size_t i = 1; i < 81; i += 2) parts.costs[i] = ChaseMap::kObstacle;
  const ChaseMap map(parts);
  EXPECT_FALSE(detail::way_over_blocks(chase_of(map, Clock::zero), 3));
}

}  // namespace
}  // namespace taut::pursuit
