// Words that were misspelt, forgotten or are one too many: who typed them is told which, and what may have been meant.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::EndsWith;
using testing::Eq;

class Spelling : public ProgramTest {
 protected:
  static std::string complaint(const std::string& words) {
    const Outcome run = run_taut(words);
    EXPECT_EQ(run.code, 2) << words;
    const std::string begin = "taut: ", end = "; see `taut";
    const std::size_t at = run.err.rfind(end);
    if (!run.err.starts_with(begin) || at == std::string::npos) return run.err;
    return run.err.substr(begin.size(), at - begin.size());
  }
};

TEST_F(Spelling, OfASubcommandIsGuessed) {
  EXPECT_THAT(complaint("slove m.txt"), Eq("there is no subcommand or option 'slove'; did you mean 'solve'?"));
  EXPECT_THAT(complaint("gen"), Eq("there is no subcommand or option 'gen'; did you mean 'generate'?"));
  EXPECT_THAT(complaint("grid scenario"), Eq("there is no subcommand or option 'scenario'; did you mean 'scen'?"));
  EXPECT_THAT(complaint("version"), Eq("there is no subcommand or option 'version'; did you mean '--version'?"));
  EXPECT_THAT(complaint("help slove"), Eq("there is no subcommand 'slove'; did you mean 'solve'?"));
  EXPECT_THAT(complaint("xyzzy"), Eq("there is no subcommand or option 'xyzzy'"));
}

TEST_F(Spelling, OfAnOptionIsGuessedAlsoWhereMoreIsMissing) {
  EXPECT_THAT(complaint("solve m.txt --samlpes 3"), Eq("there is no option --samlpes; did you mean '--samples'?"));
  EXPECT_THAT(complaint("solve m.txt --sampels 3"), Eq("there is no option --sampels; did you mean '--samples'?"));
  EXPECT_THAT(complaint("solve --robots=disc:1"), Eq("there is no option --robots; did you mean '--robot'?"));
  EXPECT_THAT(complaint("solve m.txt -z"), Eq("there is no option -z"));
}

TEST_F(Spelling, OfWhatAnOptionTakesIsGuessed) {
  EXPECT_THAT(complaint("grid solve m.csv --algorithm dikstra"), EndsWith("jps; did you mean 'dijkstra'?"));
}

TEST_F(Spelling, LeavesNoWordWithoutUse) {
  EXPECT_THAT(complaint("solve m.txt other.txt"), Eq("'other.txt' is a word too many"));
}

TEST_F(Spelling, NamesTheOptionThatNeedsAValue) {
  EXPECT_THAT(complaint("solve m.txt --seed"), Eq("--seed needs a value, N"));
  EXPECT_THAT(complaint("solve m.txt --json a --json b"), Eq("--json is given 2 times"));
  EXPECT_THAT(complaint("solve"), Eq("FILE is required"));
}

}  // namespace
}  // namespace taut::test
