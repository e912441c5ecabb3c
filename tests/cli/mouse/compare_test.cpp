// taut mouse compare, as its users run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/mouse/mazes.h"
#include "support/program_test.h"
#include "support/text.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

class MouseCompare : public ProgramTest {};

TEST_F(MouseCompare, SummarisesAllExplorersOverManyMazes) {
  const Outcome run = run_taut("mouse compare " + data_file("mouse_12.cells") + " " + data_file("mouse_16.maz"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("explorer "));
  EXPECT_THAT(run.out, ContainsRegex("\nscore +[0-9.]+ +[0-9.]+ +[0-9.]+ +0 "));
  EXPECT_EQ(lines_of(run.out).size(), 11U);
}

TEST_F(MouseCompare, AgreesWithSingleRuns) {
  const json all = json::parse(run_taut("mouse compare --explorers flood,score --json - " +
                                        data_file("mouse_12.cells") + " " + data_file("mouse_16.num"))
                                   .out)["result"];
  ASSERT_EQ(all["explorers"].size(), 2U);
  for (const json& explorer : all["explorers"]) {
    double sum = 0;
    for (const json& one : explorer["runs"]) {
      const json single =
          json::parse(run_taut("mouse run --quick --json - --explorer " + explorer["explorer"].get<std::string>() +
                               " " + one["maze"].get<std::string>())
                          .out)["result"];
      EXPECT_EQ(single["score"], one["score"]);
      sum += one["score"].get<double>();
    }
    EXPECT_NEAR(explorer["mean"], sum / 2, 1e-9);
    EXPECT_EQ(explorer["failures"], 0);
  }
}

TEST_F(MouseCompare, ShowsHowMuchSeedsMatter) {
  const std::string mazes = " " + data_file("mouse_12.cells") + " " + data_file("mouse_16.num");
  const Outcome run = run_taut("mouse compare --explorers flood,score --seeds 3" + mazes);
  EXPECT_THAT(run.out, ContainsRegex("\nscore: [0-9.]+, [0-9.]+, [0-9.]+ by seed; standard deviation of the mean "));
  EXPECT_THAT(run.out, Not(HasSubstr("flood: ")));
  const json all = json::parse(run_taut("mouse compare --explorers score --seeds 3 --json -" + mazes).out)["result"];
  const json means = all["explorers"][0]["seed_means"];
  ASSERT_EQ(means.size(), 3U);
  EXPECT_EQ(means[0], all["explorers"][0]["mean"]);
  const json third = json::parse(run_taut("mouse compare --explorers score --seed 3 --json -" + mazes).out)["result"];
  EXPECT_EQ(means[2], third["explorers"][0]["mean"]);
}

TEST_F(MouseCompare, KeepsTheScoresThatItHasWhenItIsStopped) {
  std::string mazes;
  for (int i = 0; i < 2000; ++i) mazes += " " + data_file("mouse_16.maz");
  const std::string answer = in_folder("a.json");
  const Outcome run = run_taut("mouse compare --explorers score,prove --max-seconds 10 --json " + answer + mazes);
  EXPECT_EQ(run.code, 4);
  const json envelope = json::parse(contents(answer));
  EXPECT_EQ(envelope["status"], "stopped");
  const json first = envelope["result"]["explorers"][0];
  EXPECT_EQ(first["explorer"], "score");
  ASSERT_GE(first["runs"].size(), 1U);
  EXPECT_NEAR(first["runs"][0]["score"], first["mean"], 1e-9);
  EXPECT_THAT(run.out, StartsWith("explorer "));
}

TEST_F(MouseCompare, LeavesOutMazesWithoutARoute) {
  const std::string sealed = folder.file("sealed", kSealed);
  const Outcome run = run_taut("mouse compare --explorers flood " + sealed + " " + data_file("mouse_12.cells"));
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("left out"));
  EXPECT_EQ(run_taut("mouse compare " + sealed).code, 1);
  EXPECT_EQ(run_taut("mouse compare --explorers magic " + sealed).code, 2);
  EXPECT_THAT(run_taut("mouse compare --explorers flood,foo " + sealed).err,
              HasSubstr("--explorers: 'foo' is not one of"));
}

}  // namespace
}  // namespace taut::test
