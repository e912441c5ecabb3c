// taut batch with lines that add walls and take them away.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class WallLines : public ProgramTest {
 protected:
  Outcome run(const std::string& lines, const std::string& options = "") {
    const std::string room = folder.file("room.txt", "0 0 9 0\n9 0 9 9\n9 9 0 9\n0 9 0 0\n4 0 4 6\n");
    return run_taut("batch " + room + " - " + options, lines);
  }
};

TEST_F(WallLines, ChangeTheWorldForTheQueriesAfterThem) {
  const std::string lines =
      "1 1 3 1\n"
      "+wall 2 0 2 9\n"
      "1 1 3 1 none\n"
      "  -wall 2 5 2 4 # a door\n"
      "1 4 3 4\n"
      "-wall 4 0 4 6\n"
      "3 1 5 1\n";
  for (const char* options : {"", "--index"}) {
    const Outcome outcome = run(lines, options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "1 2\n3 none\n5 2\n7 2\n") << options;
  }
}

TEST_F(WallLines, MakeAnIndexStaleWhenAWallThatItKnowsIsTakenAway) {
  EXPECT_THAT(run("+wall 2 0 2 9\n1 1 3 1\n-wall 2 0 2 9\n1 1 3 1\n", "--index").err, Not(HasSubstr("stale")));
  EXPECT_THAT(run("1 1 3 1\n-wall 4 6 4 5\n3 1 5 1\n", "--index").err, HasSubstr("<stdin>:2: the index is stale"));
}

TEST_F(WallLines, AreRefusedWhereTheyMakeNoSense) {
  const Outcome none = run("1 1 3 1\n-wall 2 0 2 1\n");
  EXPECT_EQ(none.code, 3);
  EXPECT_EQ(none.out, "1 2\n") << "what came before is answered";
  EXPECT_THAT(none.err, HasSubstr("<stdin>:2: no wall stands there"));
  EXPECT_THAT(run("+wall 2 0 2\n").err, HasSubstr("<stdin>:1: too few numbers"));
  EXPECT_THAT(run("+wall 2 0 2 3 7\n").err, HasSubstr("<stdin>:1: a wall is four numbers"));
  EXPECT_THAT(run("+wall 2 0 2 12\n").err, HasSubstr("(2, 12) lies outside the world"));
  EXPECT_EQ(run("+wall 2 0 2 12\n").code, 3);
}

}  // namespace
}  // namespace taut::test
