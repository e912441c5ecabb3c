// Generated mazes: what they are, and that no drive in them is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/drivers.h>
#include <taut/robots/roadblocks/roadblock_map_generator.h>

#include "support/second_car.h"

namespace taut::roadblocks {
namespace {

/// Different samples of the map.
std::vector<RoadblockSet> outcomes(const RoadblockMap& map) {
  std::vector<RoadblockSet> sets;
  for (const Sample& sample : map.samples) sets.push_back(sample.open);
  std::ranges::sort(sets);
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  return sets;
}

Drive driven(LatticePlanner& planner, RoadblockSet open, DriverKind kind, Aim aim = Aim::expected) {
  return drive(planner.course(), open, *make_driver(kind, planner, open, aim), planner.reading());
}

void expect_same_in_second_car(const RoadblockMap& map, const Drive& run, WallReading reading) {
  const test::Replay again = test::replay(map.course, run.open, run.controls, reading);
  EXPECT_EQ(again.reached, run.outcome == Outcome::reached);
  EXPECT_FALSE(again.collided);
  EXPECT_EQ(again.steps, run.controls.size());
}

/// Samples with a way for the clairvoyant are reached, the others end with no route.
void expect_none_lost(const RoadblockMap& map, WallReading reading) {
  LatticePlanner planner(map.course, reading);
  for (const RoadblockSet open : outcomes(map)) {
    const Drive bound = driven(planner, open, DriverKind::clairvoyant);
    const Drive run = driven(planner, open, DriverKind::policy);
    EXPECT_EQ(run.outcome, bound.outcome) << bits_of(open, map.course) << "\n" << roadblock_map_text(map);
    expect_same_in_second_car(map, bound, reading);
    expect_same_in_second_car(map, run, reading);
  }
}

TEST(RoadMapGenerator, MakesTheSameMapForTheSameSeedAndReadsItBack) {
  const RoadblockMapRecipe recipe{40, 36, 4, 7, 11};
  const RoadblockMap map = generate_roadblock_map(recipe);
  const std::string text = roadblock_map_text(map, "remark");
  EXPECT_EQ(text, roadblock_map_text(generate_roadblock_map(recipe), "remark"));
  EXPECT_EQ(roadblock_map_text(read_roadblock_map(text), "remark"), text);
  EXPECT_EQ(map.samples.size(), 7U);
  EXPECT_NE(text, roadblock_map_text(generate_roadblock_map({40, 36, 4, 7, 12}), "remark"));
  EXPECT_THROW(generate_roadblock_map({23, 36, 4, 7, 11}), InputError);
  EXPECT_THROW(generate_roadblock_map({40, 36, 27, 7, 11}), InputError);
}

TEST(RoadMapGenerator, MakesAsManyRoadblocksAsAskedForThoughThereAreFewerLanes) {
  for (const auto& [side, blocks] : {std::pair{50, 16}, {50, 26}, {44, 12}, {35, 8}})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(testing::Message() << side << " with " << blocks << ", seed " << seed);
      const RoadblockMap map = generate_roadblock_map({side, side, blocks, 1, seed});
      ASSERT_EQ(map.course.roadblocks.size(), static_cast<std::size_t>(blocks));
      std::set<std::pair<int, int>> cells;
      for (const Roadblock& block : map.course.roadblocks)
        for (const Cell c : block.cells) {
          EXPECT_FALSE(map.course.is_wall(c));
          EXPECT_TRUE(cells.emplace(c.x, c.y).second) << "in two roadblocks";
        }
    }
}

TEST(RoadMapGenerator, LaysNoLaneNarrowerThanAskedFor) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RoadblockMapRecipe recipe{50, 50, 16, 1, seed};
    EXPECT_EQ(generate_roadblock_map(recipe).course.walls,
              generate_roadblock_map({50, 50, 16, 1, seed, 2}).course.walls);
    recipe.narrowest = 3;
    const Course course = generate_roadblock_map(recipe).course;
    LatticePlanner planner(course, WallReading::squares);
    EXPECT_TRUE(planner.estimate({course.start.x, course.start.y, 0}, 0)) << seed << ": squares leave the car a way";
  }
  EXPECT_THROW(generate_roadblock_map({50, 50, 16, 1, 1, 1}), InputError);
  EXPECT_THROW(generate_roadblock_map({50, 50, 16, 1, 1, 7}), InputError);
}

TEST(RoadMapGenerator, LeavesRoomAtTheStartAndHasBothKindsOfSamples) {
  int reached = 0, none = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const RoadblockMap map = generate_roadblock_map({24, 24, 26, 1, seed});
    EXPECT_NO_THROW(require_start_free(map.course, WallReading::squares)) << seed;
    if (seed > 10) continue;
    LatticePlanner planner(map.course, WallReading::points);
    (driven(planner, map.samples[0].open, DriverKind::clairvoyant).outcome == Outcome::reached ? reached : none) += 1;
  }
  EXPECT_GT(reached, 0);
  EXPECT_GT(none, 0);
}

// TAUT_CAR_MAZES=200 drives as many of 47 x 47 cells.
TEST(Drive, LosesNoSampleOfGeneratedMazesThatAKnowingDriverReaches) {
  const char* many = std::getenv("TAUT_CAR_MAZES");
  const int mazes = many ? std::atoi(many) : 40, side = many ? 50 : 31, blocks = many ? 5 : 3;
  for (int seed = 1; seed <= mazes; ++seed) {
    SCOPED_TRACE(seed);
    expect_none_lost(generate_roadblock_map({side, side, blocks, many ? 10 : 2, static_cast<std::uint64_t>(seed)}),
                     WallReading::points);
  }
}

TEST(Drive, LosesNoSampleWhereWallsAreSquares) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    expect_none_lost(generate_roadblock_map({31, 31, 3, 2, seed}), WallReading::squares);
  }
}

TEST(Drive, OfEveryDriverReplaysInTheSecondCar) {
  for (std::uint64_t seed = 41; seed <= 44; ++seed) {
    const RoadblockMap map = generate_roadblock_map({31, 31, 3, 4, seed});
    LatticePlanner planner(map.course, WallReading::points);
    for (const RoadblockSet open : outcomes(map)) {
      for (const DriverKind kind : {DriverKind::optimist, DriverKind::pessimist})
        expect_same_in_second_car(map, driven(planner, open, kind), WallReading::points);
      expect_same_in_second_car(map, driven(planner, open, DriverKind::policy, Aim::worst), WallReading::points);
    }
  }
}

}  // namespace
}  // namespace taut::roadblocks
