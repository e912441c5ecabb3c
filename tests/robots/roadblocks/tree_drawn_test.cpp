// The trees that planners of trees grew, for pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/peers.h>
#include <taut/robots/roadblocks/tree_planner.h>

#include "support/car_drawing.h"
#include "support/paths.h"
#include "support/run_program.h"

namespace taut::roadblocks {
namespace {

/// A room with a gate, closed in sight of the start, and a wide way round.
RoadblockMap room() {
  std::vector<std::string> rows(24, "#" + std::string(30, '.') + "#");
  rows.front() = rows.back() = std::string(32, '#');
  for (std::size_t y = 1; y < 15; ++y)
    if (y < 3 || y > 7) rows[y][15] = '#';
  rows[5][15] = 'A';
  rows[5][4] = 'S';
  rows[5][26] = 'G';
  return test::map_of(rows);
}

Drive driven(const Course& course, const char* planner, std::uint64_t seed, RoadblockSet open) {
  const auto driver = peer_named(planner)->make(course, WallReading::points, seed);
  return drive(course, open, *driver, WallReading::points);
}

bool passes(const std::vector<TreeBranch>& tree, const Pose& pose) {
  return std::ranges::any_of(tree, [&](const TreeBranch& branch) {
    return std::ranges::any_of(branch.way, [&](Point p) { return std::hypot(p.x - pose.x, p.y - pose.y) < 1e-9; });
  });
}

TEST(DrawnTree, HoldsTheWholeDriveAlongItsPlans) {
  const RoadblockMap map = room();
  for (const RoadblockSet open : {RoadblockSet{0}, RoadblockSet{1}})
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const Drive run = driven(map.course, "rrt", seed, open);
      ASSERT_EQ(run.outcome, Outcome::reached);
      ASSERT_EQ(run.replans, open == 0 ? 1 : 0);
      const auto tree = trees_of(map.course, WallReading::points, TreeKind::rrt, seed, run);
      for (const Pose& pose : run.poses) ASSERT_TRUE(passes(tree, pose)) << open << " " << seed;
      EXPECT_GT(tree.size(), 20U);
    }
}

TEST(DrawnTree, OfTwoTreesTellsWhichGrewFromTheGoal) {
  const RoadblockMap map = read_roadblock_map(test::contents(test::data_dir() / "car" / "rooms_31x31.txt"), "rooms");
  TreePlanner planner(map.course, WallReading::points, TreeKind::rrt_connect, 1);
  std::vector<TreeBranch> tree;
  planner.plan({map.course.start.x, map.course.start.y, 0}, 0, &tree);
  EXPECT_TRUE(std::ranges::any_of(tree, &TreeBranch::from_goal));
  EXPECT_FALSE(std::ranges::all_of(tree, &TreeBranch::from_goal));
}

TEST(DrawnTree, DoesNotChangeThePlan) {
  const RoadblockMap map = room();
  const Pose start{map.course.start.x, map.course.start.y, 0};
  for (const TreeKind kind : {TreeKind::rrt, TreeKind::rrt_field, TreeKind::rrt_connect}) {
    TreePlanner plain(map.course, WallReading::points, kind, 3), drawn(map.course, WallReading::points, kind, 3);
    std::vector<TreeBranch> tree;
    const Attempt a = plain.plan(start, 1), b = drawn.plan(start, 1, &tree);
    ASSERT_TRUE(a.plan && b.plan);
    EXPECT_EQ(a.plan->controls, b.plan->controls);
    EXPECT_FALSE(tree.empty());
  }
}

}  // namespace
}  // namespace taut::roadblocks
