// taut mouse run, as its users run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/mouse/mazes.h"
#include "support/program_test.h"

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
    const json all = json::parse(run.out);
    EXPECT_DOUBLE_EQ(all["score"], all["run2"].get<int>() + all["run1"].get<int>() / 30.0);
    EXPECT_GE(all["run2"], all["optimum"]);
    EXPECT_DOUBLE_EQ(all["floor"], all["optimum"].get<int>() + (all["optimum"].get<int>() + 1) / 30.0);
    EXPECT_EQ(all["steps"].size(), all["run1"].get<std::size_t>() + all["run2"].get<std::size_t>());
    EXPECT_TRUE(!all["proven"].get<bool>() || all["run2"] == all["optimum"]);
    EXPECT_EQ(all["explorer"], explorer);
  }
}

TEST_F(MouseRun, ProvesInProveMode) {
  const json all = json::parse(run_taut("mouse run --quick --json - --mode prove " + data_file("mouse_16.maz")).out);
  EXPECT_EQ(all["explorer"], "prove");
  EXPECT_EQ(all["proven"], true);
  EXPECT_EQ(all["run2"], all["optimum"]);
  EXPECT_EQ(json::parse(run_taut("mouse run --quick --json - " + data_file("mouse_16.maz")).out)["explorer"], "score");
}

TEST_F(MouseRun, KnowsTheFirstMazeOfTheCourse) {
  const auto shared = shared_data_dir();
  if (!shared) GTEST_SKIP() << "no shared data";
  const json all =
      json::parse(run_taut("mouse run --json - " + (*shared / "micromouse/test_maze_01.txt").string()).out);
  EXPECT_EQ(all["optimum"], 17);
  EXPECT_NEAR(all["floor"], 17.6, 1e-12);
  EXPECT_NEAR(all["benchmarks"]["every_cell"], 21.8, 1e-12);
  EXPECT_GE(all["score"], all["floor"]);
}

TEST_F(MouseRun, RunsEveryCompetitionMaze) {
  const auto shared = shared_data_dir();
  if (!shared || !std::filesystem::exists(*shared / "micromouse/competition")) GTEST_SKIP() << "no shared data";
  std::size_t ran = 0, without_route = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*shared / "micromouse/competition")) {
    SCOPED_TRACE(entry.path());
    const Outcome run = run_taut("mouse run --quick --json - '" + entry.path().string() + "'");
    if (run.code == 1) {
      EXPECT_THAT(run.err, HasSubstr("no way from the start to the goal"));
      ++without_route;
      continue;
    }
    ++ran;
    ASSERT_EQ(run.code, 0) << run.err;
    const json all = json::parse(run.out);
    EXPECT_GE(all["score"], all["floor"]);
  }
  EXPECT_EQ(ran + without_route, 66U);
  EXPECT_EQ(without_route, 4U);
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
  EXPECT_EQ(json::parse(run.out)["score"], nullptr);
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

}  // namespace
}  // namespace taut::test
