// The planners to compare with: what they drive, and what they say when they cannot.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/peers.h>
#include <taut/robots/roadblocks/replanning_driver.h>

#include "support/car_drawing.h"
#include "support/paths.h"
#include "support/second_car.h"
#include "support/text.h"

namespace taut::roadblocks {
namespace {

Drive driven(const RoadblockMap& map, const Peer& peer, RoadblockSet open, std::uint64_t seed = 1,
             WallReading reading = WallReading::points) {
  return drive(map.course, open, *peer.make(map.course, reading, seed), reading);
}

/// A room with a gate 5 wide, closed in sight of the start, and a wide way round.
RoadblockMap rooms() {
  std::vector<std::string> rows(24, "#" + std::string(30, '.') + "#");
  rows.front() = rows.back() = std::string(32, '#');
  for (std::size_t y = 1; y < 15; ++y)
    if (y < 3 || y > 7) rows[y][15] = '#';
  rows[5][15] = 'A';
  rows[5][4] = 'S';
  rows[5][26] = 'G';
  return test::map_of(rows);
}

class EveryPeer : public testing::TestWithParam<std::size_t> {
 protected:
  const Peer& peer = peers()[GetParam()];
};

TEST_P(EveryPeer, ReachesTheGoalAndReplaysInTheSecondSimulator) {
  const RoadblockMap map = rooms();
  for (const RoadblockSet open : {0U, 1U}) {
    const Drive run = driven(map, peer, open);
    ASSERT_EQ(run.outcome, Outcome::reached) << peer.name;
    EXPECT_EQ(run.replans, open == 0 ? 1 : 0);
    const test::Replay again = test::replay(map.course, open, run.controls);
    EXPECT_TRUE(again.reached);
    EXPECT_FALSE(again.collided);
    EXPECT_EQ(again.steps, run.controls.size());
  }
}

TEST_P(EveryPeer, DrivesTheSameWithTheSameSeed) {
  const RoadblockMap map = rooms();
  EXPECT_EQ(driven(map, peer, 1, 7).controls, driven(map, peer, 1, 7).controls);
}

TEST(TreeDrivers, DriveOtherwiseWithAnotherSeed) {
  const RoadblockMap map = rooms();
  for (const char* name : {"rrt", "rrt-field"})
    EXPECT_NE(driven(map, *peer_named(name), 1, 7).controls, driven(map, *peer_named(name), 1, 8).controls);
}

TEST_P(EveryPeer, TouchesNoSolidSquareOnTheWholeStep) {
  const RoadblockMap map = rooms();
  const Drive run = driven(map, peer, 1, 1, WallReading::squares);
  ASSERT_EQ(run.outcome, Outcome::reached);
  for (std::size_t i = 0; i < run.controls.size(); ++i)
    ASSERT_FALSE(collides(run.poses[i], run.controls[i], map.course, 0, WallReading::squares));
}

RoadblockMap map_in(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return read_roadblock_map(text.str(), file.string());
}

// On the shared map it gave up with 40 000 samples that all had joints.
TEST(TreeDrivers, OfRrtStarGrowOnWithoutJointsWhereThoseGiveNoPlan) {
  std::vector<std::filesystem::path> files{test::data_dir() / "car" / "lane.txt"};
  if (const auto shared = test::shared_data_dir()) files.push_back(*shared / "car" / "map_2.txt");
  for (const auto& file : files) {
    const RoadblockMap map = map_in(file);
    const Drive run = driven(map, *peer_named("rrt-star"), 0, 2);
    ASSERT_EQ(run.outcome, Outcome::reached) << file;
    EXPECT_TRUE(test::replay(map.course, 0, run.controls).reached);
    EXPECT_FALSE(test::replay(map.course, 0, run.controls).collided);
  }
}

TEST_P(EveryPeer, SaysNoRouteWhereNotEvenADiscGetsThrough) {
  std::vector<std::string> rows(9, "#" + std::string(40, '.') + "#");
  rows.front() = rows.back() = std::string(42, '#');
  for (std::size_t y = 1; y < 8; ++y)
    if (y < 3 || y > 5) rows[y][25] = '#';
  rows[4][25] = 'A';
  rows[4][4] = 'S';
  rows[4][36] = 'G';
  const RoadblockMap map = test::map_of(rows);
  const Drive run = driven(map, peer, 0);
  EXPECT_EQ(run.outcome, Outcome::no_route) << peer.name;
  EXPECT_LT(run.controls.size(), 2000U);
}

INSTANTIATE_TEST_SUITE_P(Peers, EveryPeer, testing::Range<std::size_t>(0, peers().size()),
                         [](const auto& which) { return test::words(peers()[which.param].name); });

TEST(ReplanningDriver, SaysNoRouteOnlyWhenThatIsProven) {
  const RoadblockMap map = rooms();
  for (const bool proven : {false, true}) {
    const auto driver = replanning_driver([proven](const Pose&, RoadblockSet) { return Attempt{{}, proven}; });
    EXPECT_EQ(drive(map.course, 1, *driver, WallReading::points).outcome,
              proven ? Outcome::no_route : Outcome::gave_up);
  }
}

// By map and roadblocks: steps of another value iteration on the shared maps, of this one on ours.
TEST(ValueIterationDriver, TakesNoMoreStepsThanIsKnownOfItsMaps) {
  std::map<std::filesystem::path, std::vector<std::pair<std::string, std::size_t>>> known{
      {test::data_dir() / "car" / "lane.txt", {{"1", 401}, {"0", 1466}}},
      {test::data_dir() / "car" / "rooms_31x31.txt", {{"111", 519}, {"100", 708}, {"101", 1158}}}};
  if (const auto shared = test::shared_data_dir()) {
    known[*shared / "car" / "map_1.txt"] = {{"0", 1907}, {"1", 777}};
    known[*shared / "car" / "map_2.txt"] = {{"111", 1374}, {"010", 1374}, {"101", 4128}, {"000", 8641}};
  }
  for (const auto& [file, bounds] : known) {
    const RoadblockMap map = map_in(file);
    for (const auto& [bits, steps] : bounds) {
      const RoadblockSet open = roadblocks_of(bits, map.course);
      const Drive run = driven(map, *peer_named("value-iteration"), open);
      ASSERT_EQ(run.outcome, Outcome::reached) << file << " " << bits;
      EXPECT_LE(run.controls.size(), steps);
      EXPECT_TRUE(test::replay(map.course, open, run.controls).reached);
      EXPECT_FALSE(test::replay(map.course, open, run.controls).collided);
    }
  }
}

}  // namespace
}  // namespace taut::roadblocks
