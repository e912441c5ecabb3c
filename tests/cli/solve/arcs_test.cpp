#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kMaze = data_file("maze_5x7.txt");

class SolveArcs : public ProgramTest {};

TEST_F(SolveArcs, AnswersWithTrueArcs) {
  const Outcome outcome = run_taut("solve " + kMaze + " --robot disc:0.3 --arcs");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("length 10.370362, 5 arcs"));
  EXPECT_THAT(run_taut("solve " + kMaze + " --robot disc:0.3 --arcs --svg -").out, HasSubstr(" 0 0 0 "));
  EXPECT_THAT(run_taut("solve " + kMaze + " --robot disc:0.3 --arcs --json -").out, HasSubstr("\"verified\": true"));
}

TEST_F(SolveArcs, NamesTheWallThatIsTooNear) {
  const Outcome outcome = run_taut("solve " + kMaze + " --robot disc:0.51 --arcs");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("too near for the robot to the wall"));
}

TEST_F(SolveArcs, SaysWhichGapIsTooNarrow) {
  const Outcome outcome = run_taut("solve - --robot disc:1 --arcs --from 5,2 --to 5,8",
                                   "0 0 10 0\n10 0 10 10\n10 10 0 10\n0 10 0 0\n0 5 4 5\n5.5 5 10 5\n");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("no path: this gate is narrower than 2: 3/2 between"));
}

TEST_F(SolveArcs, DrawsTheDiscAtBothEndsAndWhereItIsPinched) {
  const char* hall = "0 0 10 0\n10 0 10 10\n10 10 0 10\n0 10 0 0\n0 5 4 5\n5.5 5 10 5\n";
  const Outcome drawn = run_taut("solve - --robot disc:0.5 --arcs --from 5,2 --to 5,8 --svg -", hall);
  const std::size_t from = drawn.out.find("<g class=\"discs\">"), to = drawn.out.find("</g>", from);
  ASSERT_NE(from, std::string::npos);
  const std::string discs = drawn.out.substr(from, to - from);
  std::size_t count = 0;
  for (std::size_t at = 0; (at = discs.find("<circle", at)) != std::string::npos; ++at) ++count;
  EXPECT_EQ(count, 3U) << discs;
  const json answer =
      json::parse(run_taut("solve - --robot disc:0.5 --arcs --from 5,2 --to 5,8 --json -", hall).out)["result"];
  EXPECT_EQ(answer["pinch"]["width_text"], "3/2");
  EXPECT_EQ(answer["pinch"]["at"][1], 5);
}

TEST_F(SolveArcs, NeedsADisc) { EXPECT_EQ(run_taut("solve " + kMaze + " --arcs").code, 2); }

}  // namespace
}  // namespace taut::test
