// --csv and --html of whatever compares, and comparisons over many worlds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

class ReportFiles : public ProgramTest {};

TEST_F(ReportFiles, OfManyWorldsHaveARowForEachRun) {
  const Outcome run = run_taut("compare " + data_file("maze_5x7.txt") + " " + data_file("floor_plan.geojson") +
                               " --planners polyanya,prm --runs 3 --json - --csv " + in_folder("rows.csv") +
                               " --html " + in_folder("page.html"));
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = json::parse(run.out)["result"];
  ASSERT_EQ(result["worlds"].size(), 2);
  const std::string csv = contents(in_folder("rows.csv"));
  EXPECT_THAT(csv, StartsWith("file,name,roadmap,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * (1 + 3));
  EXPECT_THAT(contents(in_folder("page.html")), HasSubstr("Box plots of ratio"));
  const auto is_rate = [](const json& row) { return row["name"] == "prm" && row["measure"] == "solved"; };
  const auto rate = std::find_if(result["summary"].begin(), result["summary"].end(), is_rate);
  ASSERT_NE(rate, result["summary"].end());
  EXPECT_EQ((*rate)["rows"], 6);
  EXPECT_EQ((*rate)["mean"], 1.0);
}

TEST_F(ReportFiles, OfManyWorldsDrawNoPicture) {
  const Outcome run = run_taut("compare " + data_file("maze_5x7.txt") + " " + data_file("maze_25x25.txt") + " --svg " +
                               in_folder("a.svg"));
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("for one world"));
}

TEST_F(ReportFiles, AreWrittenByAllThatCompares) {
  for (const std::string& command :
       {"grid compare " + data_file("pocket.csv"),
        "mouse compare " + data_file("mouse_12.cells") + " " + data_file("mouse_16.num"),
        "chase compare " + data_file("town_60x40.chase"), "bug compare " + data_file("maze_25x25.txt"),
        "drive --all " + data_file("car/lane.txt")}) {
    const Outcome run = run_taut(command + " --html " + in_folder("page.html"));
    ASSERT_EQ(run.code, 0) << command << run.err;
    EXPECT_THAT(contents(in_folder("page.html")), HasSubstr("<h2>All rows</h2>")) << command;
    EXPECT_THAT(contents(in_folder("page.html")), HasSubstr("Box plots of ")) << command;
  }
}

TEST_F(ReportFiles, OfAllDrivesHaveARowADrive) {
  const std::string map = data_file("car/rooms_31x31.txt"), file = " --csv " + in_folder("drives.csv");
  const Outcome run = run_taut("drive --all --json - " + map + file);
  const std::string csv = contents(in_folder("drives.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + json::parse(run.out)["result"]["samples"].size()) << csv;
  EXPECT_THAT(csv.substr(0, csv.find('\n')), HasSubstr("steps"));
  EXPECT_THAT(run_taut("drive --sample 1 " + map + file).err, HasSubstr("--csv needs --car"));
}

}  // namespace
}  // namespace taut::test
