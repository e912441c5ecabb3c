#include <taut/search/planners.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include <taut/io/worlds/read_world.h>

namespace taut {
namespace {

using testing::HasSubstr;

// A wall from the bottom, 3 of 4 high: 2 * sqrt(2) around its end.
constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\nstart 1 2\ngoal 3 2\n";

Goal to(Point p) { return {p, {}}; }

TEST(RoadmapKindTable, HaveNamesOfTheirOwnAndALineForThoseWhoChoose) {
  std::set<std::string> names;
  for (const RoadmapKind& kind : roadmap_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_GT(std::string(kind.what).size(), 10U) << kind.name;
    EXPECT_EQ(roadmap_kind(kind.name), &kind);
  }
}

TEST(RoadmapKindTable, CountWhatWasDrawnAndKeptWhereTheySample) {
  const FreeSpace space(read_world(kRoom));
  for (const RoadmapKind& kind : roadmap_kinds()) {
    if (std::string(kind.name).starts_with("cells")) continue;  // no grid
    const PlannedRoadmap planned = kind.build(space, {});
    EXPECT_EQ(planned.counts.has_value(), kind.samples) << kind.name;
    if (planned.counts) {
      EXPECT_EQ(planned.counts->kept, planned.roadmap->vertex_count()) << kind.name;
    }
  }
}

TEST(Planners, HaveARoadmapEachAndALineForThoseWhoChoose) {
  std::set<std::string> names;
  for (const Planner& p : planners()) {
    EXPECT_TRUE(names.insert(p.name).second) << p.name;
    EXPECT_NE(roadmap_kind(p.kind), nullptr) << p.name;
    EXPECT_GT(std::string(p.what).size(), 10U) << p.name;
  }
}

TEST(Comparison, TakesTheOptimumFromThePlannerThatPromisesIt) {
  const FreeSpace space(read_world(kRoom));
  Comparison comparison{{1, 2}, to({3, 2})};
  const auto run = [&](const char* name) {
    comparison.add(run_planner(*planner(name), space, comparison.start, comparison.goal, 1, 2));
  };
  run("prm");
  EXPECT_FALSE(comparison.optimum);
  run("polyanya");
  ASSERT_TRUE(comparison.optimum);
  EXPECT_EQ(*comparison.optimum, Length(std::vector<Point>{{1, 2}, {2, 3}, {3, 2}}));
  EXPECT_EQ(comparison.planners[0].runs.size(), 2U) << "once a seed";
  EXPECT_EQ(comparison.planners[1].runs.size(), 1U) << "nothing random about it";
  EXPECT_EQ(comparison.wrong(), nullptr);
  EXPECT_GT(comparison.planners[1].typical().build.cpu, 0);
}

TEST(Comparison, NamesThePlannerWhosePathDoesNotPassTheCheck) {
  const FreeSpace space(read_world(kRoom));
  Comparison comparison{{1, 2}, to({3, 2})};
  comparison.add(run_planner(*planner("polyanya"), space, comparison.start, comparison.goal, 1, 1));
  comparison.planners.front().runs.front().verified = false;
  ASSERT_NE(comparison.wrong(), nullptr);
  EXPECT_STREQ(comparison.wrong()->planner->name, "polyanya");
}

}  // namespace
}  // namespace taut
