// How the program ends, and what it says when it does: one line, and nothing on stdout unless there is a result.
#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/program_test.h"
#include "support/sanitized.h"

namespace taut::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

// A room with a wall from the bottom, 3 of 4 high.
constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\nstart 1 2\ngoal 3 2\n";
// The wall reaches the top.
constexpr const char* kSealed = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 4\nstart 1 2\ngoal 3 2\n";

void expect_one_line(const Outcome& run, int code, const std::string& says) {
  EXPECT_EQ(run.code, code) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, StartsWith("taut: "));
  EXPECT_THAT(run.err, HasSubstr(says));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

class ExitCode : public ProgramTest {};

TEST_F(ExitCode, IsZeroWithOneLineWhenAPathIsFound) {
  const Outcome run = run_taut("solve -", kRoom);
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, StartsWith("<stdin>: length 2.828427, 1 corner, "));
  EXPECT_THAT(run.out, EndsWith(" s CPU\n"));
}

TEST_F(ExitCode, IsOneWithTheWallWhenThereIsNoPath) {
  const Outcome run = run_taut("solve -", kSealed);
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out, "<stdin>: no path: this wall separates start and goal: (2, 0)-(2, 4)\n");
}

TEST_F(ExitCode, IsTwoWhenTheCommandLineMakesNoSense) {
  for (const char* arguments : {"",
                                "frobnicate",
                                "--frobnicate",
                                "solve",
                                "solve - --frobnicate",
                                "solve - extra",
                                "solve - --from",
                                "solve - --from 1",
                                "solve - --from 1,x",
                                "solve - --from nan,1",
                                "solve - --to 1,2,3",
                                "solve - --robot disc",
                                "solve - --robot disc:0",
                                "solve - --robot square:-1",
                                "solve - --wall-thickness -1",
                                "solve - --algorithm magic",
                                "solve - --format pdf",
                                "solve - --polygons some",
                                "solve - --max-seconds soon",
                                "solve - --max-memory 0",
                                "solve - --svg - --json -",
                                "solve - --seed x",
                                "check - --path -",
                                "roadmap - --kind magic",
                                "generate",
                                "generate --size 0",
                                "generate --size 3x",
                                "generate --size 3x3x3",
                                "generate --size 20001",
                                "generate --size 3 --loops 2",
                                "generate --size 3 --kind magic",
                                "generate --size 3 --as maz",
                                "generate --size 3 --as pdf",
                                "generate --size 4 --as cells",
                                "generate --size 30 --kind roadblocks --as maz",
                                "generate --size 30 --kind roadblocks --loops 0.5",
                                "generate --size 3 --samples 2",
                                "mouse run - --seed -1",
                                "mouse run - --seed 99999999999999999999",
                                "mouse run - --format wkt",
                                "chase --online compare -",
                                "chase - compare -",
                                "bug --range 3 compare -",
                                "chase - --plan-seconds soon",
                                "convert -",
                                "convert - --as pdf"}) {
    SCOPED_TRACE(arguments);
    expect_one_line(run_taut(arguments, kRoom), 2, "taut: ");
  }
}

TEST_F(ExitCode, IsThreeWhenTheInputIsWrong) {
  const struct {
    const char* bytes;
    const char* says;
  } cases[] = {
      {"", "<stdin>: file is empty"},
      {"\n \n", "<stdin>: file is empty"},
      {"\x01\x02\x03", "binary"},
      {"hello world\n", "<stdin>:1: "},
      {"0 0 1 0\n0 0 nan 1\n", "<stdin>:2: "},
      {"0 0 1e308 1\n", "<stdin>:1: "},
      {"0 0 1\n", "<stdin>:1: "},
      {"POLYGON((0 0, 1 0, 1 1))", "not closed"},
      {"POLYGON((0 0, 4 4, 4 0, 0 4, 0 0))", "crosses itself"},
      {"4\n1,2,3,4\n", "<stdin>"},
      {"{\"type\": \"Polygon\"", "<stdin>:1: "},
  };
  for (const auto& [bytes, says] : cases) {
    SCOPED_TRACE(bytes);
    expect_one_line(run_taut("solve -", bytes), 3, says);
    expect_one_line(run_taut("check -", bytes), 3, says);
  }
}

TEST_F(ExitCode, IsThreeWhenThereIsNoSuchFileOrItIsAFolder) {
  expect_one_line(run_taut("solve /no/such/file"), 3, "/no/such/file: ");
  expect_one_line(run_taut("solve ''"), 3, "'': ");
  expect_one_line(run_taut("solve " + folder.path().string()), 3, "directory");
}

TEST_F(ExitCode, IsThreeWhenStartOrGoalIsInAWallOrOutside) {
  expect_one_line(run_taut("solve - --from 9,9", "boundary 0 0 4 4\n" + std::string(kRoom)), 3, "start (9, 9)");
  expect_one_line(run_taut("solve - --to -1,2", "boundary 0 0 4 4\n" + std::string(kRoom)), 3, "goal (-1, 2)");
  expect_one_line(run_taut("solve - --wall-thickness 0.5 --from 2.1,1", kRoom), 3, "start (2.1, 1)");
  expect_one_line(run_taut("check - --wall-thickness 0.5 --to 2.1,1", kRoom), 3, "goal (2.1, 1)");
}

TEST_F(ExitCode, IsThreeWithTheOptionsThatHelpWhenNoStartOrGoalIsKnown) {
  const char* walls = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n";
  expect_one_line(run_taut("solve -", walls), 3, "--from X,Y and --to X,Y");
  expect_one_line(run_taut("solve - --from 1,1", walls), 3, "--to X,Y");
  expect_one_line(run_taut("solve - --to 1,1", walls), 3, "--from X,Y");
  EXPECT_EQ(run_taut("solve - --from 1,1 --to 3,3", walls).code, 0);
}

TEST_F(ExitCode, IsFourWhenTheTimeIsUp) {
  ASSERT_EQ(mkfifo((folder / "endless").c_str(), 0600), 0);
  const Outcome run = run_taut("solve - --max-seconds 0.1 --json " + (folder / "out.json").string() + " <>" +
                               (folder / "endless").string());
  expect_one_line(run, 4, "--max-seconds 0.1");
  EXPECT_THAT(contents(folder / "out.json"), HasSubstr("\"status\": \"stopped\""));
}

TEST_F(ExitCode, IsFourWhenInterrupted) {
  ASSERT_EQ(mkfifo((folder / "endless").c_str(), 0600), 0);
  expect_one_line(run_taut("solve - <>" + (folder / "endless").string(), "", 0.3), 4, "interrupted");
}

TEST_F(ExitCode, IsFourWhenMemoryRunsOut) {
  if (kSanitized) GTEST_SKIP() << "memory cannot be limited";
  const Outcome maze = run_taut("generate --size 600");
  expect_one_line(run_taut("solve - --max-memory 20M", maze.out), 4, "out of memory");
}

TEST_F(ExitCode, IsFourWhenStandardOutputIsFull) {
  const Outcome run = run_taut("solve - >/dev/full", kRoom);
  expect_one_line(run, 4, "<stdout>: cannot write");
}

TEST_F(ExitCode, IsZeroForHelpAndVersion) {
  EXPECT_THAT(run_taut("--version").out, StartsWith("taut "));
  EXPECT_EQ(run_taut("--version").code, 0);
  for (const char* arguments :
       {"--help", "solve --help", "check --help", "roadmap --help", "generate --help", "convert --help"}) {
    const Outcome run = run_taut(arguments);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("Usage: taut"));
  }
}

}  // namespace
}  // namespace taut::test
