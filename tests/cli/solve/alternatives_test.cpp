// taut solve --alternatives.
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

constexpr const char* kBar = "0 0 10 0\n10 0 10 10\n10 10 0 10\n0 10 0 0\n4 5 7 5\nstart 6 4\ngoal 6 6\n";

class SolveAlternatives : public ProgramTest {};

TEST_F(SolveAlternatives, ListsLengthAndNarrowestGate) {
  const Outcome run = run_taut("solve - --alternatives 5 --svg " + in_folder("a.svg"), kBar);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("1  2.828427   0.000000  3 between (7, 5) and (10, 5)\n"));
  EXPECT_THAT(run.out, HasSubstr("2  4.472136   1.643709  4 between (0, 5) and (4, 5)\n"));
  EXPECT_THAT(run.out, HasSubstr("there are no more\n"));
  const std::string picture = contents(in_folder("a.svg"));
  EXPECT_THAT(picture, HasSubstr("<g class=\"shades\">"));
  EXPECT_THAT(picture, HasSubstr("length 4.472136, 4 wide"));
}

TEST_F(SolveAlternatives, WritesThemAllAsJsonAndCsv) {
  const json answer = json::parse(run_taut("solve - --alternatives 2 --json -", kBar).out)["result"];
  EXPECT_EQ(answer["query"], "alternatives");
  EXPECT_EQ(answer["verified"], true);
  ASSERT_EQ(answer["alternatives"].size(), 2U);
  EXPECT_EQ(answer["alternatives"][1]["width_text"], "4");
  EXPECT_EQ(answer["alternatives"][1]["points"], json::parse("[[6, 4], [4, 5], [6, 6]]"));
  EXPECT_THAT(run_taut("solve - --alternatives 2 --csv - --quiet", kBar).out, HasSubstr("\n2,4,5\n"));
}

TEST_F(SolveAlternatives, NamesTheWallsThatLeaveNone) {
  const Outcome run =
      run_taut("solve - --alternatives 2", "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 4\nstart 1 2\ngoal 3 2\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("no path: this wall separates start and goal: (2, 0)-(2, 4)"));
}

TEST_F(SolveAlternatives, ThatAreWiderShowWhatRoomCosts) {
  const json answer = json::parse(run_taut("solve - --alternatives wider --json -", kBar).out)["result"];
  EXPECT_EQ(answer["asked"], "wider");
  ASSERT_EQ(answer["alternatives"].size(), 2U);
  EXPECT_EQ(answer["alternatives"][0]["width"], 3);
  EXPECT_EQ(answer["alternatives"][1]["width"], 4);
  // From here the wider way is the shorter one.
  EXPECT_EQ(
      json::parse(
          run_taut("solve - --alternatives wider --from 5,4 --to 5,6 --json -", kBar).out)["result"]["alternatives"]
          .size(),
      1U);
}

TEST_F(SolveAlternatives, HaveASearchOfTheirOwn) {
  EXPECT_EQ(run_taut("solve - --alternatives 2 --keep 1", kBar).code, 2);
  EXPECT_EQ(run_taut("solve - --alternatives 0", kBar).code, 2);
  EXPECT_EQ(run_taut("solve - --alternatives 2 --path", kBar).code, 2);
}

}  // namespace
}  // namespace taut::test
