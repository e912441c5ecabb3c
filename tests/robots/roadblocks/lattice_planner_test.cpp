// Plans and their parts: the estimate that is repaired, shortcuts, what is adopted.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include <taut/robots/roadblocks/detail/pose_distance.h>
#include <taut/robots/roadblocks/detail/replay.h>
#include <taut/robots/roadblocks/detail/shortcuts.h>
#include <taut/robots/roadblocks/lattice_planner.h>
#include <taut/robots/roadblocks/roadblock_map_generator.h>

namespace taut::roadblocks {
namespace {

Pose start_of(const RoadblockMap& map) { return {map.course.start.x, map.course.start.y, 0}; }

TEST(PoseDistance, RepairedAfterARoadblockClosesEqualsOneMadeAnew) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const RoadblockMap map = generate_roadblock_map({31, 31, 3, 0, seed});
    const Point goal = map.course.goal;
    const detail::Obstacles open(map.course, 0, WallReading::points);
    const detail::DiscDistance open_disc(open, goal);
    const detail::PoseDistance before(open, open_disc, goal);
    for (const RoadblockSet closed : {1U, 5U, 7U}) {
      const detail::Obstacles obstacles(map.course, closed, WallReading::points);
      const detail::DiscDistance disc(obstacles, goal);
      const detail::PoseDistance anew(obstacles, disc, goal), repaired(before, open, obstacles, disc);
      int finite = 0;
      for (double x = 1; x < 31; x += 0.31)
        for (double y = 1; y < 31; y += 0.37) {
          const Pose pose{x, y, x * y};
          ASSERT_EQ(anew.steps_from(pose), repaired.steps_from(pose)) << seed << " " << closed;
          finite += anew.steps_from(pose) < detail::PoseDistance::kFar;
        }
      EXPECT_GT(finite, 100);
    }
  }
}

TEST(StepTable, SaysWhatItsPoseDistanceSaysInAFractionOfTheMemory) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const RoadblockMap map = generate_roadblock_map({31, 31, 3, 0, seed});
    const detail::Obstacles closed(map.course, 7, WallReading::points);
    const Point goal = map.course.goal;
    const detail::PoseDistance distance(closed, detail::DiscDistance(closed, goal), goal);
    const detail::StepTable table = distance.table();
    EXPECT_LT(3 * table.bytes(), distance.bytes());
    int finite = 0;
    for (double x = -1; x < 34; x += 0.21)
      for (double y = -1; y < 34; y += 0.17) {
        const Pose pose{x, y, 3 * x * y - 20};
        ASSERT_EQ(table.steps_from(pose), distance.steps_from(pose)) << seed << ": " << x << " " << y;
        finite += table.steps_from(pose) < detail::StepTable::kFar;
      }
    EXPECT_GT(finite, 100);
  }
  const detail::StepTable none(std::vector<std::uint16_t>(4 * detail::StepTable::kHeadings, detail::StepTable::kNever),
                               2);
  EXPECT_EQ(none.steps_from({1, 1, 0}), detail::StepTable::kFar);
}

TEST(PoseDistance, IsWithinATenthOfWhatPlansNeed) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const RoadblockMap map = generate_roadblock_map({31, 31, 0, 0, seed});
    const detail::Obstacles open(map.course, 0, WallReading::points);
    const detail::PoseDistance distance(open, detail::DiscDistance(open, map.course.goal), map.course.goal);
    LatticePlanner planner(map.course, WallReading::points);
    const DrivePlan* plan = planner.plan(start_of(map), 0);
    if (!plan) continue;
    const auto steps = static_cast<double>(plan->controls.size());
    EXPECT_NEAR(distance.steps_from(start_of(map)), steps, 0.1 * steps + 10) << seed;
  }
}

TEST(Shortcuts, PullAWeavingPlanStraightAndGoAroundAPillar) {
  RoadblockMap map;
  map.course = {31, 31, std::vector<std::uint8_t>(31 * 31), {}, {5, 15}, {27, 15}};
  DrivePlan weaving;
  Pose pose = start_of(map);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 40; ++k) {
      weaving.controls.push_back(k < 10 || k >= 30 ? 1 : -1);
      weaving.poses.push_back(pose = stepped(pose, weaving.controls.back()));
    }
  const auto shortened = [&] {
    const detail::Obstacles obstacles(map.course, 0, WallReading::points);
    const DrivePlan plan = detail::with_shortcuts(start_of(map), weaving, obstacles, kMargin);
    EXPECT_TRUE(detail::replayed(start_of(map), plan.controls, obstacles, kMargin).has_value());
    return static_cast<double>(plan.controls.size());
  };
  weaving = *detail::replayed(start_of(map), weaving.controls, detail::Obstacles(map.course, 0, WallReading::points),
                              kMargin);
  EXPECT_NEAR(shortened(), 137, 1) << "(27 - 5 - 1.5) / 0.15 straight ahead";
  map.course.walls[map.course.index({19, 14})] = 1;  // in the straight car's side, and beside the weaving one
  EXPECT_LT(shortened(), 145);
}

TEST(LatticePlanner, GivesTheRestOfAnAdoptedPlanWithoutASearch) {
  const RoadblockMap map = generate_roadblock_map({31, 31, 3, 0, 3});
  LatticePlanner planner(map.course, WallReading::points);
  const DrivePlan* plan = planner.plan(start_of(map), 0);
  ASSERT_NE(plan, nullptr);
  const std::size_t searches = planner.plans(), half = plan->controls.size() / 2;
  planner.adopt(*plan, half, 0);
  const DrivePlan* rest = planner.plan(plan->poses[half - 1], 0);
  ASSERT_NE(rest, nullptr);
  EXPECT_EQ(planner.plans(), searches);
  EXPECT_EQ(rest->controls.size(), plan->controls.size() - half);
  EXPECT_EQ(rest->poses.back(), plan->poses.back());
}

/// Two rooms and a lane with A; B stands free in the first room.
Course two_rooms() {
  Course course{40,     20,     std::vector<std::uint8_t>(40 * 20, 1), {{'A', 0.5, {{20, 10}}}, {'B', 0.5, {{12, 15}}}},
                {6, 8}, {34, 8}};
  for (int y = 2; y < 20; ++y)
    for (int x = 2; x < 40; ++x)
      if (x < 15 || x > 27 || y == 10 || y == 11) course.walls[course.index({x, y})] = 0;
  return course;
}

TEST(LatticePlanner, SearchesNoMoreWhereTheStartIsProvenToBeCutOff) {
  const Course course = two_rooms();
  LatticePlanner planner(course, WallReading::points);
  const Pose start{6, 8, 0}, elsewhere{8, 10, 0};
  EXPECT_EQ(planner.plan(start, 0b01), nullptr);
  EXPECT_FALSE(planner.gave_up(start, 0b01));
  const std::size_t plans = planner.plans();
  EXPECT_EQ(planner.plan(elsewhere, 0b11), nullptr);
  EXPECT_FALSE(planner.gave_up(elsewhere, 0b11));
  EXPECT_EQ(planner.plans(), plans);
  EXPECT_NE(planner.plan(elsewhere, 0b10), nullptr);
  EXPECT_NE(planner.plan(elsewhere, 0), nullptr);
}

}  // namespace
}  // namespace taut::roadblocks
