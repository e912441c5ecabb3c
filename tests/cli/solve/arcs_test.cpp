#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program_test.h"

namespace taut::test {
namespace {

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
  EXPECT_THAT(outcome.err, HasSubstr("nearer than the disc's radius to the wall"));
}

TEST_F(SolveArcs, SaysWhichGapIsTooNarrow) {
  const Outcome outcome = run_taut("solve - --robot disc:1 --arcs --from 5,2 --to 5,8",
                                   "0 0 10 0\n10 0 10 10\n10 10 0 10\n0 10 0 0\n0 5 4 5\n5.5 5 10 5\n");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("too narrow: 3/2 between"));
}

TEST_F(SolveArcs, NeedsADisc) { EXPECT_EQ(run_taut("solve " + kMaze + " --arcs").code, 2); }

}  // namespace
}  // namespace taut::test
