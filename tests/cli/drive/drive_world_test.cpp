// taut drive --car.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/paths.h"
#include "support/run_program.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class DriveWorld : public testing::Test {
 protected:
  void SetUp() override {
    if (!program()) GTEST_SKIP() << "the program is not built";
  }
  const std::string maze = TAUT_DATA_DIR "/maze_25x25.txt";
  const std::string car = " --car length=0.4,width=0.2,radius=0.3";
};

TEST_F(DriveWorld, DrivesThroughAMaze) {
  const Outcome outcome = run_taut("drive " + maze + car + " --json -");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json envelope = json::parse(outcome.out), result = envelope["result"];
  EXPECT_EQ(envelope["status"], "found");
  EXPECT_EQ(result["reached"], true);
  EXPECT_EQ(result["collisions"], 0);
  EXPECT_EQ(result["verified"], true);
  EXPECT_GT(result["length"], result["lower_bound"]);
  EXPECT_LT(result["length"], 50);
  double length = 0;
  for (const json& segment : result["segments"]) length += std::abs(segment["length"].get<double>());
  EXPECT_NEAR(length, result["length"], 1e-9);
}

TEST_F(DriveWorld, DrawsAndAnimates) {
  const Outcome outcome = run_taut("drive " TAUT_DATA_DIR "/islands.wkt" + car + " --svg - --animate");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("class=\"swept\""));
  EXPECT_THAT(outcome.out, HasSubstr("<animate attributeName=\"d\""));
}

TEST_F(DriveWorld, SaysWhyThereIsNoDrive) {
  const Outcome none = run_taut(
      "drive -" + car, "start 1 1\ngoal 5 1\nboundary 0 0 6 4\n0 0 6 0\n6 0 6 4\n6 4 0 4\n0 4 0 0\n3 0 3 3.9\n");
  EXPECT_EQ(none.code, 1) << none.err;
  EXPECT_THAT(none.out, HasSubstr("not even the disc of radius 0.1 inside the car gets through"));
  const Outcome unproven = run_taut("drive - --car length=0.4,width=0.2,radius=9,reverse=no --from 1,1,0",
                                    "goal 0.5 3\nboundary 0 0 6 4\n0 0 6 0\n6 0 6 4\n6 4 0 4\n0 4 0 0\n");
  EXPECT_EQ(unproven.code, 4) << unproven.err;
  EXPECT_THAT(unproven.out, HasSubstr("which proves nothing"));
}

TEST_F(DriveWorld, ReadsTheMapBesideARosFile) {
  const Folder folder;
  std::ofstream(folder / "map.pgm") << "P2 3 1 255 255 255 255\n";
  std::ofstream(folder / "map.yaml") << "image: map.pgm\nresolution: 2\norigin: [0, 0, 0]\n";
  const Outcome outcome = run_taut("drive " + (folder / "map.yaml").string() + car + " --from 1,1,0 --to 5,1");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("length 4.0"));
}

TEST_F(DriveWorld, EndsWithItsCode) {
  EXPECT_EQ(run_taut("drive " + maze + " --car length=0.4,width=0.2").code, 2);
  EXPECT_EQ(run_taut("drive " + maze + " --car length=0.4,width=0.2,radius=0").code, 2);
  EXPECT_EQ(run_taut("drive " + maze + car + ",wheels=4").code, 2);
  EXPECT_EQ(run_taut("drive " + maze + car + " --from 1,2,x").code, 2);
  EXPECT_EQ(run_taut("drive " + maze + car + " --weight 0.5").code, 2);
  EXPECT_EQ(run_taut("drive " + maze + car + " --all").code, 2);
  EXPECT_EQ(run_taut("drive " TAUT_DATA_DIR "/car/lane.txt --from 1,1").code, 2);
  for (const char* option : {"--snap auto", "--repair", "--resolution 1", "--unknown-free"})
    EXPECT_EQ(run_taut(std::string("drive " TAUT_DATA_DIR "/car/lane.txt ") + option).code, 2) << option;
  const Outcome fixed = run_taut("drive " TAUT_DATA_DIR "/car/lane.txt" + car);
  EXPECT_EQ(fixed.code, 3);
  EXPECT_THAT(fixed.err, HasSubstr("whose rules fix the car"));
  const Outcome which = run_taut("drive " + maze);
  EXPECT_EQ(which.code, 3);
  EXPECT_THAT(which.err, HasSubstr("--car"));
  const Outcome wall = run_taut("drive " + maze + car + " --from 0.5,3");
  EXPECT_EQ(wall.code, 3);
  EXPECT_THAT(wall.err, HasSubstr("the car cannot stand at the start (0.5, 3)"));
}

}  // namespace
}  // namespace taut::test
