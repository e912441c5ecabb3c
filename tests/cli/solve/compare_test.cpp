// taut compare, and the roadmaps that solve and roadmap choose, save and load.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class Compare : public ProgramTest {};
class SavedRoadmaps : public ProgramTest {};
class RoadmapKinds : public ProgramTest {};

constexpr std::size_t kPlanners = 10;  // that fit a grid maze

TEST_F(Compare, PrintsALineForEachPlanner) {
  const Outcome run = run_taut("compare " + data_file("maze_5x7.txt"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("planner "));
  EXPECT_THAT(run.out, ContainsRegex("visibility-astar +yes +9.321693 +1 "));
  EXPECT_THAT(run.out, ContainsRegex("cells4 +yes +13.000000 +1.3946 "));
  EXPECT_EQ(static_cast<std::size_t>(std::count(run.out.begin(), run.out.end(), '\n')), 1 + kPlanners);
}

TEST_F(Compare, NeverFindsAnythingShorterThanTheOptimum) {
  for (const char* name : {"maze_25x25.txt", "mouse_16.maz", "half_open_60x60.txt"}) {
    const json all = json::parse(run_taut("compare --json - " + data_file(name)).out)["result"];
    ASSERT_EQ(all["planners"].size(), kPlanners);
    for (const json& planner : all["planners"]) {
      SCOPED_TRACE(planner["name"]);
      EXPECT_EQ(planner["solved"], 1.0);
      EXPECT_EQ(planner["verified"], true);
      EXPECT_GE(planner["ratio"], 1.0);
      EXPECT_TRUE(planner["optimal"] == false || planner["ratio"] == 1.0);
    }
  }
}

TEST_F(Compare, MeasuresAgainstTheOptimumAlsoWhenOnlyCellsRun) {
  const json all =
      json::parse(run_taut("compare --planners cells8,cells4 --json - " + data_file("maze_5x7.txt")).out)["result"];
  ASSERT_EQ(all["planners"].size(), 2U);
  EXPECT_EQ(all["planners"][0]["name"], "cells8");
  EXPECT_NEAR(all["optimum"], 9.321693, 1e-6);
  EXPECT_NEAR(all["planners"][1]["ratio"], 1.3946, 1e-4);
}

TEST_F(Compare, RunsRandomisedPlannersWithSeveralSeeds) {
  const json all = json::parse(
      run_taut("compare --planners prm --runs 3 --seed 5 --json - " + data_file("maze_25x25.txt")).out)["result"];
  EXPECT_EQ(all["planners"][0]["solved"], 1.0);
  EXPECT_EQ(all["planners"][0]["verified"], true);
}

TEST_F(Compare, OfSeveralRunsHasQuartilesBelow) {
  const std::string query = "compare --planners polyanya,prm " + data_file("maze_25x25.txt");
  const std::string several = run_taut(query + " --runs 3").out;
  EXPECT_THAT(several, ContainsRegex("solved +ratio +lower +median +upper +most"));
  EXPECT_THAT(several, ContainsRegex("polyanya +1 +1 +1 +1 +1 +1 "));
  EXPECT_EQ(run_taut(query).out.find("lower"), std::string::npos) << "of one run there are none";
}

TEST_F(RoadmapKinds, SolveWithAFixedNumberOfSamplesToo) {
  const Outcome lattice = run_taut("solve --roadmap prm-lattice " + data_file("maze_45x45.txt"));
  EXPECT_EQ(lattice.code, 0) << lattice.err;
  EXPECT_THAT(lattice.out, HasSubstr("not proven optimal"));
  EXPECT_EQ(run_taut("solve --roadmap prm-fixed --seed 2 " + data_file("maze_5x7.txt")).code, 0);
}

TEST_F(Compare, LeavesOutWhatDoesNotFitUnlessItWasAskedFor) {
  const Outcome all = run_taut("compare " + data_file("islands.wkt"));
  EXPECT_EQ(all.code, 0);
  EXPECT_THAT(all.out, Not(HasSubstr("cells4")));
  EXPECT_THAT(all.err, HasSubstr("cells4 did not run"));
  const Outcome asked = run_taut("compare --planners cells4 " + data_file("islands.wkt"));
  EXPECT_EQ(asked.code, 3);
  EXPECT_THAT(asked.err, HasSubstr("has no cells"));
  EXPECT_EQ(run_taut("compare --planners magic " + data_file("islands.wkt")).code, 2);
}

TEST_F(Compare, SaysNoneWhereThereIsNoPath) {
  const Outcome run =
      run_taut("compare -", "0 0 3 0\n3 0 3 2\n3 2 0 2\n0 2 0 0\n1 0 1 2\nstart 0.5 0.5\ngoal 2.5 0.5\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, ContainsRegex("visibility-astar +no +- +- "));
}

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

TEST_F(Compare, DrawsAPanelForEachPlannerOnOneSheetWithOneLegendAndOneWorld) {
  const Outcome run = run_taut("compare --svg - " + data_file("maze_5x7.txt"));
  EXPECT_THAT(run.out, StartsWith("<svg xmlns="));
  EXPECT_THAT(run.out, HasSubstr(" width=\"1000\""));
  EXPECT_EQ(count(run.out, "<text class=\"panel\""), kPlanners);
  EXPECT_EQ(count(run.out, "<use xlink:href=\"#taut-walls\"/>"), kPlanners);
  EXPECT_EQ(count(run.out, "<g class=\"walls\">"), 1U);
  EXPECT_EQ(count(run.out, "<g class=\"legend\">"), 1U);
  EXPECT_EQ(count(run.out, "id=\"taut-roadmap-0\""), 1U);
  EXPECT_GE(count(run.out, "<use xlink:href=\"#taut-roadmap-"), 1U) << "A* and Dijkstra share a roadmap";
  EXPECT_LT(run.out.size(), 100'000U);
}

TEST_F(Compare, DrawsTheSameSheetEveryTime) {
  const std::string query = "compare --svg - " + data_file("maze_25x25.txt");
  EXPECT_EQ(run_taut(query).out, run_taut(query).out);
}

TEST_F(Compare, KeepsThePlannersThatFinishedWhenItIsStopped) {
  const std::string maze = folder.file("maze.txt", run_taut("generate --size 60x60 --loops 0.3 --seed 2").out);
  // A PRM that never finds a way: its milestones keep too far from the walls.
  const Outcome run =
      run_taut("compare --planners polyanya,prm --prm-clearance 0.6 --samples 100000000 --max-seconds 3 --json " +
               in_folder("a.json") + " " + maze);
  EXPECT_EQ(run.code, 4) << run.out << run.err;
  EXPECT_THAT(run.out, ContainsRegex("polyanya +yes "));
  const json answer = json::parse(contents(in_folder("a.json")));
  EXPECT_EQ(answer["status"], "stopped");
  ASSERT_EQ(answer["result"]["planners"].size(), 1U);
  EXPECT_EQ(answer["result"]["planners"][0]["name"], "polyanya");
  EXPECT_EQ(answer["result"]["planners"][0]["verified"], true);
}

TEST_F(Compare, AsksWhetherAnotherNameWasMeant) {
  EXPECT_THAT(run_taut("compare --planners polyania " + data_file("maze_5x7.txt")).err,
              HasSubstr("did you mean 'polyanya'?"));
  EXPECT_THAT(run_taut("solve --roadmap visibilty " + data_file("maze_5x7.txt")).err,
              HasSubstr("did you mean 'visibility'?"));
  EXPECT_THAT(run_taut("solve --roadmap prm-homework " + data_file("maze_5x7.txt")).err,
              HasSubstr("is called prm-fixed now"));
  EXPECT_THAT(run_taut("roadmap --full " + data_file("maze_5x7.txt")).err, HasSubstr("--kind full"));
  EXPECT_THAT(run_taut("solve --start 1,1 " + data_file("maze_5x7.txt")).err, HasSubstr("did you mean `--from 1,1`?"));
}

TEST_F(Compare, HasHelp) { EXPECT_THAT(run_taut("compare --help").out, HasSubstr("Usage: taut compare")); }

TEST_F(Compare, TakesRunsAndSeed) {
  const json all =
      json::parse(run_taut("compare --runs 3 --seed 7 --json - " + data_file("maze_5x7.txt")).out)["result"];
  EXPECT_EQ(all["runs"], 3);
  EXPECT_EQ(all["seed"], 7);
  EXPECT_FALSE(all["planners"][0].contains("all_runs"));  // nothing random about it
}

TEST_F(SavedRoadmaps, AnswerAsTheRoadmapsTheyCameFrom) {
  for (const char* kind : {"visibility", "full", "cells", "cells8"}) {
    SCOPED_TRACE(kind);
    const std::string file = in_folder(kind), query = "solve --path -q " + data_file("maze_25x25.txt");
    const Outcome built = run_taut(query + " --roadmap " + kind + " --save " + file);
    EXPECT_EQ(built.code, 0) << built.err;
    EXPECT_EQ(run_taut(query + " --load " + file).out, built.out);
    EXPECT_EQ(run_taut(query + " --from 3,3 --load " + file).out,
              run_taut(query + " --from 3,3 --roadmap " + kind).out);
    EXPECT_EQ(run_taut("roadmap -q --kind " + std::string(kind) + " --save - " + data_file("maze_25x25.txt")).out,
              contents(file));
  }
}

TEST_F(SavedRoadmaps, OfTheDefinitionAndOfTheFastWayAreTheSame) {
  const auto edges = [](const std::string& kind) {
    return json::parse(run_taut("roadmap --json - --kind " + kind + " " + data_file("maze_5x7.txt")).out)["result"];
  };
  json brute = edges("visibility-brute"), fast = edges("full");
  EXPECT_THAT(brute["kind"].get<std::string>(), HasSubstr("each pair against each wall"));
  brute["kind"] = fast["kind"];
  EXPECT_EQ(brute, fast);
  const std::string solve = "solve --path -q " + data_file("maze_5x7.txt") + " --roadmap ";
  EXPECT_EQ(run_taut(solve + "visibility-brute").out, run_taut(solve + "full").out);
}

TEST_F(SavedRoadmaps, RefuseAnotherMazeKindAndDamageInOneLine) {
  const std::string file = in_folder("kept"), load = " --load " + file;
  ASSERT_EQ(run_taut("solve " + data_file("maze_25x25.txt") + " --save " + file).code, 0);
  const auto expect_refusal = [](const Outcome& run, const char* says) {
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr(says));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    EXPECT_EQ(run.out, "");
  };
  expect_refusal(run_taut("solve " + data_file("maze_5x7.txt") + load), "maze_25x25.txt (fingerprint ");
  expect_refusal(run_taut("solve " + data_file("maze_5x7.txt") + load),
                 "not of " TAUT_DATA_DIR "/maze_5x7.txt (fingerprint ");
  expect_refusal(run_taut("solve " + data_file("maze_25x25.txt") + load + " --robot disc:0.1"),
                 "built for the robot `point`");
  expect_refusal(run_taut("solve " + data_file("maze_25x25.txt") + load + " --roadmap cells"),
                 "of the kind 'visibility'");
  expect_refusal(run_taut("solve " + data_file("maze_25x25.txt") + " --load " + data_file("maze_5x7.txt")),
                 "is no saved roadmap");
  expect_refusal(run_taut("solve " + data_file("maze_25x25.txt") + " --load " + in_folder("absent")), "no such file");
  const std::string cut = folder.file("cut", contents(file).substr(0, 1000));
  expect_refusal(run_taut("solve " + data_file("maze_25x25.txt") + " --load " + cut), "is cut off");
}

TEST_F(RoadmapKinds, SayThatTheirPathsAreNotProvenOptimal) {
  const Outcome run = run_taut("solve --roadmap cells " + data_file("maze_5x7.txt"));
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, HasSubstr("length 13.000000 (shortest in the roadmap cells; not proven optimal), "));
  const json answer =
      json::parse(run_taut("solve --roadmap cells8 --json - " + data_file("maze_5x7.txt")).out)["result"];
  EXPECT_EQ(answer["optimal"], false);
  EXPECT_EQ(answer["roadmap"], "cells8");
  EXPECT_EQ(run_taut("solve --roadmap magic " + data_file("maze_5x7.txt")).code, 2);
}

// A post covers the middles of the cells that the way leads through; beside it there is room.
constexpr const char* kOffCentre = "0 0 4 0\n4 0 4 1\n4 1 0 1\n0 1 0 0\n2 0 2 0 1.4\nstart 0.5 0.5\ngoal 3.5 0.5\n";

TEST_F(RoadmapKinds, ProveNothingWhenTheyFindNoPath) {
  EXPECT_EQ(run_taut("solve -", kOffCentre).code, 0);
  const Outcome unproven = run_taut("solve --roadmap cells -", kOffCentre);
  EXPECT_EQ(unproven.code, 4);
  EXPECT_EQ(unproven.out, "<stdin>: no path in the roadmap cells, which does not prove that there is none\n");
  const Outcome separated = run_taut("solve --roadmap cells - ",
                                     "0 0 2 0\n2 0 2 1\n2 1 0 1\n0 1 0 0\n1 0 1 1\nstart 0.5 0.5\ngoal 1.5 0.5\n");
  EXPECT_EQ(separated.code, 1);
  EXPECT_THAT(separated.out, HasSubstr("this wall separates start and goal"));
}

TEST_F(RoadmapKinds, AreExported) {
  const std::string query = "roadmap --kind cells " + data_file("maze_5x7.txt");
  const json map = json::parse(run_taut(query + " --geojson -").out);
  EXPECT_EQ(map["features"].size(), 35U + 34U);
  EXPECT_THAT(run_taut(query + " --graphml -").out, HasSubstr("<edge id=\"e33\""));
  EXPECT_EQ(json::parse(run_taut(query + " --json -").out)["result"]["edges"].size(), 34U);
  EXPECT_THAT(run_taut(query).out, HasSubstr("cells with 4 neighbours, 35 vertices, 34 edges"));
  EXPECT_EQ(run_taut(query + " --geojson - --json -").code, 2);
}

}  // namespace
}  // namespace taut::test
