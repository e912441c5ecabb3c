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
