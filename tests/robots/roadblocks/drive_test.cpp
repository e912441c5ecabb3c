// Cars among walls and roadblocks, replayed by a second simulator.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/drivers.h>

#include "support/car_drawing.h"
#include "support/paths.h"
#include "support/second_car.h"
#include "support/text.h"

namespace taut::roadblocks {
namespace {

using test::lane;
using test::map_of;
using test::replay;

Drive driven(const RoadblockMap& map, RoadblockSet open, DriverKind kind = DriverKind::policy,
             WallReading reading = WallReading::points) {
  LatticePlanner planner(map.course, reading);
  return drive(map.course, open, *make_driver(kind, planner, open), reading);
}

void expect_replays(const RoadblockMap& map, const Drive& run) {
  const test::Replay again = replay(map.course, run.open, run.controls);
  EXPECT_TRUE(again.reached);
  EXPECT_FALSE(again.collided);
  EXPECT_EQ(again.steps, run.controls.size());
}

TEST(Car, TurnsOnTheSpotByThreeStepsBackAndOneArc) {
  Pose pose{10, 10, 0.3};
  for (const double u : {-2.0, -2.0, -2.0, 1.0}) pose = stepped(pose, u);
  EXPECT_NEAR(pose.heading, 0.35, 1e-12);
  EXPECT_LT(std::hypot(pose.x - 10, pose.y - 10), 0.004);
  EXPECT_EQ(stepped(pose, 1.5), pose);
  EXPECT_EQ(stepped(pose, std::nan("")), pose);
  EXPECT_NEAR(stepped({0, 0, 0}, 5e-324).x, 0.15, 1e-12);
}

TEST(Car, TouchesWhatLiesOnItsSide) {
  EXPECT_TRUE(covers({0, 0, 0}, {1.5, -1}));
  EXPECT_FALSE(covers({0, 0, 0}, {1.5, std::nextafter(-1.0, -2.0)}));
}

TEST(Car, SweptSquaresAgreeWithVeryManyPosesBetween) {
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const Pose from{0.013 * (i % 331), 0.017 * (i % 257), 0.37 * i};
    const double control = i % 5 == 0 ? kReverse : std::sin(1.0 * i);
    const Cell cell{3, 2};
    bool sampled = false;
    for (int k = 0; k <= 60; ++k) {
      const double t = k / 60.0, w = kTurn * control * t, r = kForward / (kTurn * control), h = from.heading;
      const Pose between =
          control == kReverse
              ? Pose{from.x - kBackward * t * std::cos(h), from.y - kBackward * t * std::sin(h), h}
              : Pose{from.x + r * (std::sin(h + w) - std::sin(h)), from.y - r * (std::cos(h + w) - std::cos(h)), h + w};
      sampled = sampled || touches(between, cell, WallReading::squares);
    }
    if (touches(from, cell, WallReading::squares)) continue;
    const bool exact = meets(from, control, cell, WallReading::squares);
    met += exact;
    EXPECT_TRUE(exact || !sampled) << i;  // nothing is missed
    EXPECT_TRUE(!exact || sampled || meets(from, control, cell, WallReading::squares, -1e-3) == false) << i;
  }
  EXPECT_GT(met, 20);
}

TEST(Drive, BacksOutOfALaneThreeWideWhenItsRoadblockIsClosed) {
  const RoadblockMap map = lane();
  const Drive open = driven(map, 1), closed = driven(map, 0);
  ASSERT_EQ(open.outcome, Outcome::reached);
  ASSERT_EQ(closed.outcome, Outcome::reached);
  expect_replays(map, open);
  expect_replays(map, closed);
  EXPECT_LT(open.controls.size(), 300U);
  EXPECT_EQ(closed.replans, 1);
  EXPECT_GE(std::ranges::count(closed.controls, kReverse), 400) << "some 24 cells straight back";
}

TEST(Drive, EndsWithNoRouteWhereTheOnlyWayIsClosed) {
  std::vector<std::string> rows(7, "#" + std::string(40, '.') + "#");
  rows.front() = rows.back() = std::string(42, '#');
  rows[1] = rows[5] = std::string(42, '#');
  rows[3][4] = 'S';
  rows[3][36] = 'G';
  rows[3][25] = 'A';
  const RoadblockMap map = map_of(rows);
  const Drive closed = driven(map, 0);
  EXPECT_EQ(closed.outcome, Outcome::no_route);
  EXPECT_LT(closed.controls.size(), 200U);
  EXPECT_EQ(driven(map, 1).outcome, Outcome::reached);
}

TEST(Drive, HoldsForThreeRoadblocksInARow) {
  std::vector<std::string> rows(14, "#" + std::string(48, '.') + "#");
  rows.front() = rows.back() = std::string(50, '#');
  for (const std::size_t x : {12U, 24U, 36U}) {
    for (std::size_t y = 1; y < 13; ++y)
      if (!(y >= 2 && y <= 4) && !(y >= 9 && y <= 11)) rows[y][x] = '#';
    rows[3][x] = static_cast<char>('A' + x / 12 - 1);
  }
  rows[3][4] = 'S';
  rows[3][45] = 'G';
  const RoadblockMap map = map_of(rows);
  for (RoadblockSet open = 0; open < 8; ++open) {
    const Drive run = driven(map, open);
    ASSERT_EQ(run.outcome, Outcome::reached) << bits_of(open, map.course);
    expect_replays(map, run);
  }
}

struct MapFile {
  std::filesystem::path file;
  std::size_t clairvoyant;  // steps of one who knows, where nothing that is closed lies on the way
  std::size_t no_way = 0;   // samples without one
};

void PrintTo(const MapFile& map, std::ostream* out) { *out << map.file.filename().string(); }

std::vector<MapFile> map_files() {
  std::vector<MapFile> all{{test::data_dir() / "car" / "lane.txt", 263},
                           {test::data_dir() / "car" / "rooms_31x31.txt", 195, 2}};
  if (const auto shared = test::shared_data_dir())
    for (const int number : {1, 2, 4})
      all.push_back({*shared / "car" / ("map_" + std::to_string(number) + ".txt"), number == 1 ? 212U : 309U});
  return all;
}

class EveryMap : public testing::TestWithParam<MapFile> {};

TEST_P(EveryMap, IsDrivenToTheGoalWithoutACollisionWhereThereIsAWay) {
  std::stringstream text;
  text << std::ifstream(GetParam().file).rdbuf();
  const RoadblockMap map = read_roadblock_map(text.str(), GetParam().file.string());
  LatticePlanner planner(map.course, WallReading::points);
  std::size_t no_way = 0;
  for (const Sample& sample : map.samples) {
    const Drive run = drive(map.course, sample.open, *make_driver(DriverKind::policy, planner), WallReading::points);
    if (run.outcome == Outcome::no_route) {
      ++no_way;
      continue;
    }
    ASSERT_EQ(run.outcome, Outcome::reached) << sample.number;
    expect_replays(map, run);
    if (run.replans == 0) {
      EXPECT_LE(run.controls.size(), GetParam().clairvoyant) << "what one who knows needs";
    }
  }
  EXPECT_EQ(no_way, GetParam().no_way);
}

INSTANTIATE_TEST_SUITE_P(Files, EveryMap, testing::ValuesIn(map_files()),
                         [](const auto& map) { return test::words(map.param.file.stem().string()); });

}  // namespace
}  // namespace taut::roadblocks
