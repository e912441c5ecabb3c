// taut drive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "support/paths.h"
#include "support/run_program.h"
#include "support/text.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class DriveProgram : public testing::Test {
 protected:
  void SetUp() override {
    if (!program()) GTEST_SKIP() << "the program is not built";
  }
  const std::string map = TAUT_DATA_DIR "/car/lane.txt";
};

TEST_F(DriveProgram, GivesAResultASample) {
  const Outcome outcome = run_taut("drive " + map + " --all --json -");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json results = json::parse(outcome.out)["result"]["samples"];
  ASSERT_EQ(results.size(), 2U);
  for (const json& result : results) {
    EXPECT_EQ(result["reached"], true);
    EXPECT_EQ(result["collisions"], 0);
  }
  EXPECT_EQ(results[0]["replans"], 0);
  EXPECT_EQ(results[1]["replans"], 1);
  EXPECT_LT(results[0]["steps"], results[1]["steps"]);
}

TEST_F(DriveProgram, DrawsAndAnimates) {
  const Outcome outcome = run_taut("drive " + map + " --sample 2 --svg - --animate");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("class=\"closed\""));
  EXPECT_THAT(outcome.out, HasSubstr("<animate attributeName=\"d\""));
}

TEST_F(DriveProgram, SumsUpAllSamplesAndTakesTimes) {
  const Outcome outcome = run_taut("drive " + map + " --all --policy worst");
  EXPECT_THAT(outcome.out, HasSubstr("reached 2 of 2 (100 %), mean"));
  EXPECT_THAT(outcome.out, HasSubstr("replan ms"));
  const json result = json::parse(run_taut("drive " + map + " --json -").out)["result"]["samples"][0];
  EXPECT_GT(result["first_plan_ms"], 0);
  EXPECT_GE(result["slowest_replan_ms"], 0);
  EXPECT_EQ(run_taut("drive " + map + " --policy lucky").code, 2);
}

TEST_F(DriveProgram, RefusesOptionsThatWouldBeIgnored) {
  const std::string car = "drive " + data_file("islands.wkt") + " --car length=0.4,width=0.2,radius=0.3 ";
  for (const char* option : {"--planner rrt", "--policy worst", "--walls squares", "--show-values", "--all"}) {
    const Outcome outcome = run_taut(car + option);
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr("--car drives in a world of walls: not with --")) << option;
  }
  for (const char* option : {"--weight 2", "--polygons obstacles", "--from 1,1"})
    EXPECT_THAT(run_taut("drive " + map + " " + option).err, HasSubstr(" needs --car")) << option;
  for (const char* options : {"--planner rrt --policy worst", "--controls", "--open 2"})
    EXPECT_EQ(run_taut("drive " + map + " " + options).code, 2) << options;
}

TEST_F(DriveProgram, DrivesWhatGenerateMakes) {
  std::stringstream kept;
  kept << std::ifstream(data_dir() / "car" / "rooms_31x31.txt").rdbuf();
  const Outcome made = run_taut("generate --kind roadblocks --size 31x31 --roadblocks 3 --seed 18 --samples 8");
  EXPECT_EQ(made.out, kept.str()) << "as data/README.md says";
  EXPECT_THAT(run_taut("drive - --all", made.out).out, HasSubstr("reached 6 of 8"));
  EXPECT_EQ(run_taut("generate --kind roadblocks --size 9").code, 2);
  EXPECT_EQ(run_taut("generate --kind roadblocks --size 31 --roadblocks 27").code, 2);
}

TEST_F(DriveProgram, DrawsTheValueSurfaceAndItsArrows) {
  const std::string drawn = "drive " + map + " --sample 1 --planner value-iteration --svg -";
  const Outcome outcome = run_taut(drawn);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("cells to go, best heading"));
  EXPECT_EQ(outcome.out, run_taut(drawn).out);
  EXPECT_THAT(outcome.out, HasSubstr("; a line each "));
  EXPECT_EQ(count(outcome.out, "class=\"heights\""), 2U);
  EXPECT_EQ(run_taut("drive " + map + " --show-values").code, 2);
}

TEST_F(DriveProgram, DrawsAllSamplesOnOneSheet) {
  const std::size_t samples = json::parse(run_taut("drive " + map + " --all --json -").out)["result"]["samples"].size();
  ASSERT_GT(samples, 1U);
  const Outcome sheet = run_taut("drive " + map + " --all --svg -");
  EXPECT_EQ(sheet.code, 0) << sheet.err;
  for (std::size_t i = 1; i <= samples; ++i)
    EXPECT_THAT(sheet.out, HasSubstr("lane.txt, sample " + std::to_string(i) + "<"));
}

/// The lane's map with so many samples, half of them open.
std::string many_samples(const std::string& map, int count) {
  const std::string text = contents(map);
  std::string out = text.substr(0, text.find("samples")) + "samples " + std::to_string(count) + "\n";
  for (int i = 1; i <= count; ++i) out += std::to_string(i) + (i % 2 == 0 ? " 0\n" : " 1\n");
  return out;
}

TEST_F(DriveProgram, KeepsWhatItHasDrivenWhenItIsStopped) {
  const Folder folder;
  const std::string answer = (folder / "a.json").string();
  const std::string drive = "drive " + folder.file("map", many_samples(map, 100000)) + " --all --json " + answer;
  for (const double interrupt_after : {0.0, 3.0}) {
    SCOPED_TRACE(interrupt_after);
    const Outcome run = run_taut(drive + (interrupt_after > 0 ? "" : " --max-seconds 3"), "", interrupt_after);
    EXPECT_EQ(run.code, 4);
    const json envelope = json::parse(contents(answer)), samples = envelope["result"]["samples"];
    EXPECT_EQ(envelope["status"], "stopped");
    EXPECT_THAT(envelope["reason"].get<std::string>(),
                testing::StartsWith(interrupt_after > 0 ? "interrupted" : "--max-seconds 3"));
    ASSERT_GE(samples.size(), 1U);
    EXPECT_LT(samples.size(), 100000U);
    EXPECT_EQ(samples[0]["reached"], true);
  }
}

TEST_F(DriveProgram, NamesTheNewNameOfAPlanner) {
  const Outcome outcome = run_taut("drive " + map + " --planner ours");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean `--planner policy`?"));
}

TEST_F(DriveProgram, DrawsTheSameBytesEachTimeAndForwardAsOnOtherSheets) {
  const std::string drawn = "drive " + map + " --sample 2 --svg -";
  const Outcome outcome = run_taut(drawn);
  EXPECT_EQ(outcome.out, run_taut(drawn).out);
  EXPECT_THAT(outcome.out, HasSubstr(".ahead{fill:none;stroke:#ee5a10"));
  EXPECT_THAT(outcome.out, HasSubstr("class=\"back\""));
}

TEST_F(DriveProgram, NamesItsPlannerAndSeed) {
  const Outcome outcome = run_taut("drive " + map + " --sample 1 --planner rrt-field --seed 5 --json -");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json result = json::parse(outcome.out)["result"];
  EXPECT_EQ(result["planner"], "rrt-field");
  EXPECT_EQ(result["seed"], 5);
}

TEST_F(DriveProgram, EndsWithItsCode) {
  const std::string box = "start 3 3\ngoal 12 3\ngrid 14 5\n";
  const std::string side(14, '#'), rows = "#.....#......#\n#.....#......#\n#.....#......#\n";
  const Outcome none = run_taut("drive -", box + side + "\n" + rows + side + "\n");
  EXPECT_EQ(none.code, 1) << none.err;
  EXPECT_THAT(none.out, HasSubstr("no route"));
  const Outcome wall = run_taut("drive -", "start 2 2\ngoal 3 3\ngrid 3 3\n###\n#.#\n###\n");
  EXPECT_EQ(wall.code, 3);
  EXPECT_THAT(wall.err, HasSubstr("<stdin>: the car at start (2, 2) touches the wall"));
  EXPECT_EQ(run_taut("drive " + map + " --sample 9").code, 3);
  EXPECT_EQ(run_taut("drive " + map + " --planner rr").code, 2);
  EXPECT_EQ(run_taut("drive " + map + " --all --animate x.svg").code, 2);
}

}  // namespace
}  // namespace taut::test
