// What `taut help` makes for `man` and for shells that complete.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Manual : public ProgramTest {
 protected:
  /// What bash offers after these words, the last one begun.
  std::string completed(const std::string& words) {
    const std::string script = folder.file("completion", run_taut("help --as bash").out);
    const std::string set =
        "source " + script + "; COMP_WORDS=(" + words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _taut; ";
    return run_script("bash -c '" + set + "echo \"${COMPREPLY[*]}\"'").out;
  }
};

TEST_F(Manual, HasAPageForTheProgramAndForEachSubcommand) {
  const std::string page = run_taut("help --as man").out;
  EXPECT_THAT(page, StartsWith(".TH TAUT 1 "));
  EXPECT_THAT(page, HasSubstr("\\fBtaut\\-solve\\fR(1)"));
  const std::string solve = run_taut("help grid solve --as man").out;
  EXPECT_THAT(solve, StartsWith(".TH TAUT\\-GRID\\-SOLVE 1 "));
  EXPECT_THAT(solve, HasSubstr(".SH SYNOPSIS\n\\fBtaut grid solve\\fR [OPTIONS] "));
  EXPECT_THAT(solve, HasSubstr("\\fB\\-\\-heuristic\\fR"));
  EXPECT_THAT(solve, HasSubstr(".SH EXIT STATUS"));
}

TEST_F(Manual, KeepsWhatRoffWouldTakeForItsOwn) {
  EXPECT_THAT(run_taut("help solve --as man").out, Not(HasSubstr("\n'")))
      << "a line that begins with a quote is a request";
}

TEST_F(Manual, IsRefusedForWhatIsNotThere) {
  EXPECT_EQ(run_taut("help --as csh").code, 2);
  EXPECT_EQ(run_taut("help --as").code, 2);
  EXPECT_EQ(run_taut("help nothing --as man").code, 2);
}

TEST_F(Manual, CompletesSubcommandsOptionsAndTheNamesTheyTake) {
  EXPECT_EQ(completed("taut so"), "solve\n");
  EXPECT_EQ(completed("taut grid sol"), "solve\n");
  EXPECT_EQ(completed("taut solve --alg"), "--algorithm\n");
  EXPECT_EQ(completed("taut solve --algorithm d"), "dijkstra dfs\n");
  EXPECT_EQ(completed("taut mouse run --explorer pro"), "prove\n");
  const std::string file = folder.file("world.txt", "");
  EXPECT_EQ(completed("taut solve " + folder.path().string() + "/wor"), file + "\n");
  EXPECT_EQ(completed("taut solve --svg " + folder.path().string() + "/wor"), file + "\n");
}

TEST_F(Manual, CompletesWhatHelpIsWantedOf) {
  EXPECT_EQ(completed("taut help gr"), "grid\n");
  EXPECT_EQ(completed("taut help grid sol"), "solve\n");
  EXPECT_EQ(completed("taut help solve --as m"), "man\n");
  EXPECT_EQ(completed("taut help --a"), "--as\n");
}

TEST_F(Manual, SaysWhatHelpItselfTakes) {
  const std::string page = run_taut("help help").out;
  for (const char* words : {"SUBCOMMAND", "--as KIND", "completions"}) EXPECT_THAT(page, HasSubstr(words));
  EXPECT_EQ(run_taut("help --help").out, run_taut("--help").out);
  EXPECT_EQ(run_taut("help grid -h").out, run_taut("help grid").out);
  EXPECT_THAT(run_taut("help solve --as bash").err, HasSubstr("--as bash is for all subcommands, not one"));
}

TEST_F(Manual, IsReadByTheShellsThatAreThere) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    if (run_script("command -v " + shell).code != 0) continue;
    const std::string script = folder.file("completion." + shell, run_taut("help --as " + shell).out);
    const Outcome read = run_script(shell + " -n " + script);
    EXPECT_EQ(read.code, 0) << shell << ": " << read.err;
  }
}

TEST_F(Manual, TakesNoOptionForTheValueOfAnother) {
  const Outcome run = run_taut("solve - --json --stats", "");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("--json needs a value, and --stats is an option"));
}

}  // namespace
}  // namespace taut::test
