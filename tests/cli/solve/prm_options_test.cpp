// The options of probabilistic roadmaps, --shorten, and what they refuse.
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
using testing::HasSubstr;

class PrmProgram : public ProgramTest {};

TEST_F(PrmProgram, FindsAPathWithEverySamplerAndConnection) {
  for (const char* options :
       {"--sampler uniform --connection nearest:8", "--sampler lattice --connection visible:8", "--sampler gaussian",
        "--sampler bridge", "--sampler medial-axis", "--sampler corners --lazy", "--connection radius:2",
        "--connection prm-star --eager", "--connection forest:8", "--prm-clearance 0.1", "--lazy --seed 7"}) {
    const json envelope = json::parse(
        run_taut(std::string("solve --roadmap prm --json - ") + options + " " + data_file("maze_5x7.txt")).out);
    const json answer = envelope["result"];
    SCOPED_TRACE(options);
    EXPECT_EQ(envelope["status"], "found");
    EXPECT_EQ(answer["verified"], true);
    EXPECT_GE(answer["length"], 9.321693);
    EXPECT_GE(answer["prm"]["edges_tested"], answer["prm"]["edges"]);
    EXPECT_GT(answer["prm"]["start_part"], 0);
    EXPECT_GT(answer["prm"]["goal_part"], 0);
  }
}

// 500 samples at least 0.1 from every wall, each joined to its 8 nearest.
TEST_F(PrmProgram, SolvesASmallMazeWithAFixedNumberOfSamples) {
  const std::string numbers = " --samples 500 --prm-clearance 0.1 --connection nearest:8 ";
  for (const char* seed : {"1", "2", "3"}) {
    EXPECT_EQ(run_taut("solve --roadmap prm" + numbers + "--seed " + seed + " " + data_file("maze_5x7.txt")).code, 0);
  }
  if (const auto shared = shared_data_dir()) {
    for (const char* name : {"maze_5x7_s1.txt", "maze_5x7_s2.txt"}) {
      EXPECT_EQ(run_taut("solve --roadmap prm" + numbers + (*shared / "prm" / name).string()).code, 0) << name;
    }
  }
}

TEST_F(PrmProgram, WritesTheSameBytesForTheSameSeed) {
  const std::string query = "solve --roadmap prm --path -q --save - " + data_file("maze_25x25.txt");
  const Outcome first = run_taut(query + " --seed 3");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(run_taut(query + " --seed 3").out, first.out);
  EXPECT_NE(run_taut(query + " --seed 4").out, first.out);
}

TEST_F(PrmProgram, PullsThePathToTheShortestOfAPerfectMaze) {
  const json answer =
      json::parse(run_taut("solve --roadmap prm --shorten --json - " + data_file("maze_25x25.txt")).out)["result"];
  EXPECT_EQ(answer["length_text"],
            json::parse(run_taut("solve --json - " + data_file("maze_25x25.txt")).out)["result"]["length_text"]);
  EXPECT_GT(answer["length_in_roadmap"], answer["length"]);
  EXPECT_EQ(answer["optimal"], false) << "nobody proved it";
  EXPECT_THAT(run_taut("solve --roadmap cells --shorten " + data_file("maze_5x7.txt")).out,
              HasSubstr("length 9.321693 (pulled taut from 13.000000 in the roadmap cells"));
}

TEST_F(PrmProgram, StopsUnprovenWhenTheSamplesAreUsedUp) {
  const Outcome run = run_taut("solve --roadmap prm --samples 200 --json - " + data_file("maze_25x25.txt"));
  EXPECT_EQ(run.code, 4);
  const json envelope = json::parse(run.out), answer = envelope["result"];
  EXPECT_EQ(envelope["status"], "unproven");
  EXPECT_THAT(envelope["reason"], HasSubstr("200 samples"));
  EXPECT_EQ(answer["prm"]["samples"], 200);
  EXPECT_LT(answer["prm"]["start_part"], 200);
}

TEST_F(PrmProgram, DrawsExactlyAsManySamplesAsAreAskedFor) {
  const std::string query = "solve --roadmap prm --samples 3000 --json - " + data_file("maze_5x7.txt");
  const auto prm = [&](const std::string& option) {
    return json::parse(run_taut(query + option).out)["result"]["prm"];
  };
  const json grown = prm(""), whole = prm(" --exactly");
  EXPECT_EQ(whole["samples"], 3000);
  EXPECT_LT(grown["samples"], 3000) << "the ends were joined before";
  EXPECT_EQ(run_taut("solve --roadmap prm --exactly " + data_file("maze_5x7.txt")).code, 2);
}

TEST_F(PrmProgram, ProvesThatThereIsNoPathWhereWallsSeparate) {
  const Outcome run = run_taut("solve --roadmap prm --json - -",
                               "0 0 3 0\n3 0 3 2\n3 2 0 2\n0 2 0 0\n1 0 1 2\nstart 0.5 0.5\ngoal 2.5 0.5\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(json::parse(run.out)["status"], "none");
  EXPECT_EQ(json::parse(run.out)["result"]["prm"]["samples"], 0);
}

TEST_F(PrmProgram, RefusesOptionsThatMakeNoSenseInOneLine) {
  for (const char* command :
       {"solve --sampler bridge ", "solve --roadmap cells --lazy ", "solve --roadmap prm-fixed --samples 3 ",
        "solve --roadmap prm-lattice --sampler uniform ", "solve --roadmap prm --lazy --eager ",
        "solve --roadmap prm --lazy --connection visible:3 ", "solve --roadmap prm --connection nearest:0 ",
        "solve --roadmap prm --connection radius:-1 ", "solve --roadmap prm --connection nearest:2.5 ",
        "solve --roadmap prm --sampler magic ", "solve --roadmap prm --samples 0 ", "solve --shorten ",
        "solve --roadmap prm --prm-clearance -1 ", "solve --roadmap prm --prm-clearance 0.1 --shorten ",
        "roadmap --samples 10 ", "compare --planners cells4 --samples 10 ", "solve --load x --samples 10 "}) {
    const Outcome run = run_taut(command + data_file("maze_5x7.txt"));
    SCOPED_TRACE(command);
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

TEST_F(PrmProgram, ShowsNoProgressWhereThereIsNoTerminal) {
  const Outcome run =
      run_taut("solve --roadmap prm --prm-clearance 0.6 --samples 1500000 " + data_file("maze_25x25.txt"));
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.err, "");
}

TEST_F(PrmProgram, DrawsMilestonesAsDotsAndSaysHowManyWereDrawnAndKept) {
  const Outcome run = run_taut("roadmap --kind prm-fixed --svg - " + data_file("maze_25x25.txt"));
  EXPECT_THAT(run.out, ContainsRegex("500 samples drawn, [0-9]+ kept"));
  const json map =
      json::parse(run_taut("roadmap --kind prm-fixed --json - " + data_file("maze_25x25.txt")).out)["result"];
  const std::size_t from = run.out.find("<g class=\"milestones\">"), to = run.out.find("</g>", from);
  ASSERT_NE(from, std::string::npos);
  // A dot is a move and a line of no length, isolated or not.
  const std::string dots = run.out.substr(from, to - from);
  std::size_t drawn = 0;
  for (std::size_t at = dots.find("h0"); at != std::string::npos; at = dots.find("h0", at + 2)) ++drawn;
  EXPECT_EQ(drawn, map["vertices"].size());
}

TEST_F(PrmProgram, SaysHowTheRoadmapHangsTogether) {
  EXPECT_THAT(run_taut("solve --roadmap prm --stats " + data_file("maze_5x7.txt")).err, HasSubstr(" tested, "));
  const json map = json::parse(run_taut("roadmap --kind prm --json - " + data_file("maze_5x7.txt")).out)["result"];
  EXPECT_EQ(map["prm"]["vertices"], map["vertices"].size());
  EXPECT_EQ(map["prm"]["edges"], map["edges"].size());
}

}  // namespace
}  // namespace taut::test
