// taut solve --anytime: bounds, stages and the budget.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class AnytimeProgram : public ProgramTest {};

TEST_F(AnytimeProgram, EndsWithTheShortestPathAndSaysHowItCameThere) {
  const json exact = json::parse(run_taut("solve --json - " + data_file("half_open_60x60.txt")).out)["result"];
  const Outcome run = run_taut("solve --anytime --json - " + data_file("half_open_60x60.txt"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "") << "stages are told on terminals and with --stats";
  const json answer = json::parse(run.out)["result"];
  EXPECT_EQ(answer["length_text"], exact["length_text"]);
  EXPECT_EQ(answer["optimal"], true);
  EXPECT_EQ(answer["verified"], true);
  EXPECT_EQ(answer["bound"], 1);
  ASSERT_GT(answer["improvements"].size(), 1U);
  double bound = 1e300;
  for (const json& stage : answer["improvements"]) {
    EXPECT_LT(stage["bound"], bound);
    EXPECT_LE(stage["bound"], stage["epsilon"]);
    EXPECT_LE(stage["length"].get<double>(),
              stage["bound"].get<double>() * exact["length"].get<double>() * (1 + 1e-15));
    bound = stage["bound"];
  }
}

TEST_F(AnytimeProgram, PrintsTheBoundAndTellsEachStageWithStats) {
  const Outcome run = run_taut("solve --anytime --epsilon 5 --stats " + data_file("half_open_60x60.txt"));
  EXPECT_THAT(run.out, HasSubstr("length 84.949388, bound 1, "));
  EXPECT_THAT(run.err, HasSubstr("epsilon 5: length "));
  EXPECT_THAT(run.err, HasSubstr("epsilon 1: length 84.949388, bound 1, "));
}

TEST_F(AnytimeProgram, KeepsToTheRoadmapAskedFor) {
  for (const char* kind : {"visibility", "full", "cells", "cells8", "prm", "prm-lattice"}) {
    SCOPED_TRACE(kind);
    const std::string query = std::string("solve --json - --roadmap ") + kind + " " + data_file("maze_61x61_loops.txt");
    const json plain = json::parse(run_taut(query).out)["result"],
               anytime = json::parse(run_taut(query + " --anytime").out)["result"];
    EXPECT_EQ(anytime["length_text"], plain["length_text"]);
    EXPECT_EQ(anytime["optimal"], plain["optimal"]);
  }
}

TEST_F(AnytimeProgram, EndsWithTheBestSoFarWhenTheSecondsAreOver) {
  run_taut("generate --size 120x120 --loops 0.6 -o " + (folder / "maze.txt").string());
  bool early = false;
  for (const char* seconds : {"0.1", "0.2", "0.4", "0.8", "1.6", "30"}) {
    const Outcome run = run_taut("solve --anytime --roadmap prm --samples 20000 --json - --max-seconds " +
                                 std::string(seconds) + " " + (folder / "maze.txt").string());
    const json envelope = json::parse(run.out), answer = envelope["result"];
    if (run.code == 4) {
      EXPECT_EQ(envelope["status"], "stopped");
      EXPECT_THAT(envelope["reason"].get<std::string>(), HasSubstr(std::string("--max-seconds ") + seconds));
      continue;
    }
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(answer["verified"], true);
    EXPECT_GE(answer["bound"], 1);
    early |= answer["bound"] > 1;
  }
  RecordProperty("ended_early", early);
}

TEST_F(AnytimeProgram, ProvesThatThereIsNone) {
  const Outcome run = run_taut("solve --anytime -", "boundary 0 0 4 4\nstart 1 1\ngoal 3 3\n0 2 4 2\n");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_THAT(run.out, HasSubstr("no path"));
}

TEST_F(AnytimeProgram, RefusesWhatItCannotDo) {
  for (const char* options :
       {"--epsilon 2", "--anytime --roadmap polyanya", "--anytime --roadmap voronoi", "--anytime --algorithm dijkstra",
        "--anytime --shorten --roadmap prm", "--anytime --widest"}) {
    const Outcome run = run_taut(std::string("solve ") + options + " " + data_file("maze_5x7.txt"));
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_THAT(run.err, HasSubstr("makes no sense")) << options;
  }
}

}  // namespace
}  // namespace taut::test
