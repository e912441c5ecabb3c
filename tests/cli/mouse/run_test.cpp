// taut mouse run, as its users run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/mouse/mazes.h"
#include "support/program_test.h"
#include "support/sanitized.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class MouseRun : public ProgramTest {};

TEST_F(MouseRun, PrintsATableForBothRuns) {
  const Outcome run = run_taut("mouse run " + data_file("mouse_12.cells"));
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* row :
       {"run 1 ", "run 2 ", "score ", "optimum ", "proven ", "floor ", "floor with proof ", "benchmark 1 "})
    EXPECT_THAT(run.out, HasSubstr(std::string("\n  ") + row));
}

TEST_F(MouseRun, GivesTheScoreOfItsRunsAsJson) {
  for (const char* explorer : {"dfs", "bfs", "flood", "astar", "plain-prove", "prove", "score"}) {
    SCOPED_TRACE(explorer);
    const Outcome run =
        run_taut("mouse run --quick --json - --explorer " + std::string(explorer) + " " + data_file("mouse_12.cells"));
    ASSERT_EQ(run.code, 0) << run.err;
    const json all = json::parse(run.out)["result"];
    EXPECT_DOUBLE_EQ(all["score"], all["run2"].get<int>() + all["run1"].get<int>() / 30.0);
    EXPECT_GE(all["run2"], all["optimum"]);
    EXPECT_DOUBLE_EQ(all["floor"], all["optimum"].get<int>() + (all["optimum"].get<int>() + 1) / 30.0);
    EXPECT_EQ(all["steps"].size(), all["run1"].get<std::size_t>() + all["run2"].get<std::size_t>());
    EXPECT_TRUE(!all["proven"].get<bool>() || all["run2"] == all["optimum"]);
    EXPECT_EQ(all["explorer"], explorer);
  }
}

TEST_F(MouseRun, ProvesInProveMode) {
  const json all =
      json::parse(run_taut("mouse run --quick --json - --explorer prove " + data_file("mouse_16.maz")).out)["result"];
  EXPECT_EQ(all["explorer"], "prove");
  EXPECT_EQ(all["proven"], true);
  EXPECT_EQ(all["run2"], all["optimum"]);
  const json chosen = json::parse(run_taut("mouse run --quick --json - " + data_file("mouse_16.maz")).out);
  EXPECT_EQ(chosen["result"]["explorer"], "score");
  const Outcome old = run_taut("mouse run --mode prove " + data_file("mouse_16.maz"));
  EXPECT_EQ(old.code, 2);
  EXPECT_THAT(old.err, HasSubstr("did you mean `--explorer prove`?"));
}

void expect_yardsticks(const std::string& file, int optimum, double floor, double every_cell) {
  const json all = json::parse(run_taut("mouse run --json - " + file).out)["result"];
  EXPECT_EQ(all["optimum"], optimum);
  EXPECT_NEAR(all["floor"], floor, 1e-12);
  EXPECT_NEAR(all["benchmarks"]["every_cell"], every_cell, 1e-12);
  EXPECT_GE(all["score"], all["floor"]);
}

// By the rules: the floor is (optimum + 1) / 30 for run 1 and the optimum; every cell, one step each, and the optimum.
TEST_F(MouseRun, KnowsTheYardsticksOfAMaze) {
  expect_yardsticks(data_file("mouse_12.cells"), 5, 5 + 6 / 30.0, 5 + 144 / 30.0);
  expect_yardsticks(data_file("mouse_16.maz"), 13, 13 + 14 / 30.0, 13 + 256 / 30.0);
  if (const auto shared = shared_data_dir())
    expect_yardsticks((*shared / "micromouse/test_maze_01.txt").string(), 17, 17.6, 21.8);
}

/// Whether there is a route; the robot's score is no better than that of one who knows it.
bool runs(const std::string& file) {
  SCOPED_TRACE(file);
  const Outcome run = run_taut("mouse run --quick --json - '" + file + "'");
  if (run.code == 1) {
    EXPECT_THAT(run.err, HasSubstr("no way from the start to the goal"));
    return false;
  }
  EXPECT_EQ(run.code, 0) << run.err;
  const json all = json::parse(run.out)["result"];
  EXPECT_TRUE(all.is_object() && all["score"] >= all["floor"]);
  return true;
}

TEST_F(MouseRun, RunsEveryMazeThatHasARoute) {
  for (const char* maze : {"mouse_12.cells", "mouse_16.maz", "mouse_16.num", "mouse_32.maze"})
    EXPECT_TRUE(runs(data_file(maze)));
  EXPECT_FALSE(runs(folder.file("sealed", kSealed)));
  const auto shared = shared_files("micromouse/competition");
  const auto ran = std::ranges::count_if(shared, [](const auto& file) { return runs(file.string()); });
  EXPECT_EQ(ran, shared.empty() ? 0 : 62);
  EXPECT_EQ(shared.size(), shared.empty() ? 0U : 66U);
}

TEST_F(MouseRun, SaysSoWhenTheGoalCannotBeReached) {
  for (const char* command : {"run", "serve", "speed"}) {
    SCOPED_TRACE(command);
    const Outcome run = run_taut(std::string("mouse ") + command + " " + folder.file("sealed", kSealed));
    EXPECT_EQ(run.code, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr("no way from the start to the goal"));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  }
}

TEST_F(MouseRun, HasItsScoreWhenWhatIsPossibleCannotBeMeasured) {
  if (kSanitized) GTEST_SKIP() << "memory cannot be limited";
  const std::string maze = in_folder("large"), answer = in_folder("a.json");
  ASSERT_EQ(run_taut("generate --kind backtracker --size 64 --loops 0.2 --seed 2 --as num -o " + maze).code, 0);
  const Outcome run = run_taut("mouse run --explorer flood --max-memory 300M --json " + answer + " " + maze);
  EXPECT_EQ(run.code, 4);
  const json envelope = json::parse(contents(answer));
  EXPECT_EQ(envelope["status"], "stopped");
  EXPECT_EQ(envelope["reason"], "out of memory (in stage `floor`)");
  EXPECT_GE(envelope["result"]["score"], envelope["result"]["floor"]);
  EXPECT_THAT(run.out, HasSubstr("\n  score "));
}

TEST_F(MouseRun, RefusesWhatIsNoGridMaze) {
  const Outcome run = run_taut("mouse run " + data_file("maze_5x7.txt"));
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("not a grid maze"));
  EXPECT_EQ(run_taut("mouse run " + in_folder("absent")).code, 3);
  EXPECT_EQ(run_taut("mouse run --explorer magic " + data_file("mouse_12.cells")).code, 2);
  EXPECT_EQ(run_taut("mouse run --svg - --json - " + data_file("mouse_12.cells")).code, 2);
  EXPECT_EQ(run_taut("mouse").code, 2);
  EXPECT_EQ(run_taut("mouse run --json " + in_folder("no/such/x") + " " + data_file("mouse_12.cells")).code, 3);
}

TEST_F(MouseRun, MeasuresLongMazesAndSaysWhenNoRandomWalkerFinishes) {
  const std::string slim = in_folder("slim");
  ASSERT_EQ(run_taut("generate --kind backtracker --size 250x2 --as num -o " + slim).code, 0);
  const Outcome run = run_taut("mouse run --explorer flood " + slim);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("\n  floor with proof "));
  EXPECT_THAT(run.out, HasSubstr("\n  benchmark 2               -  not ten of 1000 random walkers finish\n"));
}

TEST_F(MouseRun, FailsWithItsReasonWhenTheStepsRunOut) {
  const Outcome run = run_taut("mouse run --quick --max-steps 5 --json - " + data_file("mouse_16.maz"));
  EXPECT_EQ(run.code, 4);
  const json all = json::parse(run.out);
  EXPECT_EQ(all["status"], "unproven");
  EXPECT_EQ(all["result"]["score"], nullptr);
  EXPECT_THAT(run.err, HasSubstr("the steps ran out"));
}

TEST_F(MouseRun, NamesTheFileOfAMazeThatIsTooLarge) {
  const std::string large = in_folder("large");
  ASSERT_EQ(run_taut("generate --kind backtracker --size 257 --as drawing -o " + large).code, 0);
  for (const char* command : {"run", "serve", "speed", "compare"}) {
    const Outcome run = run_taut(std::string("mouse ") + command + " " + large);
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr(large + ": maze of 257 x 257 cells"));
  }
}

TEST_F(MouseRun, ClosesAnOpenBorderAndSaysSo) {
  const Outcome run = run_taut("mouse run --quick -", "o---o---o\n|     G |\no   o---o\n  S |   |\no---o---o\n");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the border has 1 opening"));
}

TEST_F(MouseRun, GivesTheSameBytesEachTime) {
  const std::string command = "mouse run --quick --explorer random --seed 3 --svg - " + data_file("mouse_12.cells");
  EXPECT_EQ(run_taut(command).out, run_taut(command).out);
}

TEST_F(MouseRun, StopsProvingInTimeToRace) {
  const std::string maze =
      run_taut("generate --kind backtracker --size 32 --loops 0.1 --as cells --seed 1 --quiet").out;
  // Of the 120 steps the goal takes half, and the second run 30.
  const Outcome run = run_taut("mouse run --quick --explorer prove --max-steps 120 --json - -", maze);
  EXPECT_EQ(run.code, 0) << run.err;
  const json result = json::parse(run.out)["result"];
  EXPECT_FALSE(result["proven"].get<bool>());
  EXPECT_LE(result["run1"].get<int>() + result["run2"].get<int>(), 120);
}

}  // namespace
}  // namespace taut::test
