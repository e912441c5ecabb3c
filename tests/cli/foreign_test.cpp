// Files given to the wrong subcommand, and where help is found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Foreign : public ProgramTest {
 protected:
  static void expect_refusal(const std::string& arguments, std::string_view input, const std::string& says) {
    SCOPED_TRACE(arguments);
    const Outcome run = run_taut(arguments, input);
    EXPECT_EQ(run.code, 3);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, "taut: <stdin>: " + says + "\n");
  }
};

constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\nstart 1 2\ngoal 3 2\n";
constexpr const char* kCostMap = "N 1,3 C 5 R 1,1 T 1,3 M 1,1,1";
constexpr const char* kRoadblocks =
    "start 2 2\ngoal 4 4\nroadblock A 3 3\ngrid 5 5\n#####\n#...#\n#...#\n#...#\n#####\n";
constexpr const char* kGrid = "start,0,0\ngoal,0,2\n0,0,0\n0,0,x\n";
constexpr const char* kScenarios = "version 1\n0\ta.map\t4\t3\t0\t0\t3\t0\t6.41421\n";

TEST_F(Foreign, FilesAreRefusedWithTheNameOfTheirSubcommand) {
  for (const char* command : {"solve -", "check -", "bug -", "convert - --as wkt"}) {
    expect_refusal(command, kCostMap, "is a cost map: `taut chase` reads it");
    expect_refusal(command, kScenarios,
                   "is a scenario file: `taut grid scen MAP SCEN` and `taut batch MAP SCEN` read it");
    expect_refusal(command, kRoadblocks, "is a roadblock map: `taut drive` reads it");
  }
  expect_refusal("solve -", kGrid, "is a grid map: `taut grid solve` reads it");
  expect_refusal("solve -", "taut roadmap 1\nrobot point\n", "is a saved roadmap: `taut solve MAZE --load` reads it");
  expect_refusal("chase -", kRoom, "is a world: `taut solve` reads it");
  expect_refusal("chase -", kGrid, "is a grid map: `taut grid solve` reads it");
  expect_refusal("grid solve -", kCostMap, "is a cost map: `taut chase` reads it");
  expect_refusal("grid compare -", kRoom, "is a world: `taut solve` reads it");
}

TEST_F(Foreign, CertificatesAndResultsAreKnown) {
  const std::string maze = data_file("mouse_16.maz"), proof = (folder / "proof.json").string();
  ASSERT_EQ(run_taut("mouse run " + maze + " --explorer prove -q --certificate " + proof).code, 0);
  const Outcome run = run_taut("solve " + proof);
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("is a micromouse certificate: `taut mouse check MAZE --certificate` reads it"));
  const std::string result = run_taut("check - --json -", kRoom).out;
  expect_refusal("solve -", result, "is a result of taut: `taut check MAZE --path` reads what `taut solve` wrote");
}

TEST_F(Foreign, AFileOfTheRightKindIsToldWhatIsWrongWithIt) {
  EXPECT_THAT(run_taut("chase -", "N 1,3 C 5 R 1,1 T 1,3 M 1,1").err,
              HasSubstr("section M ends too soon: 1 x 3 = 3 costs expected"));
  EXPECT_THAT(run_taut("grid solve -", "S..\n..\n").err, testing::Not(HasSubstr("reads it")));
  EXPECT_THAT(run_taut("grid solve -", "type octile\nheight 2\nwidth 2\nmap\n..\n").err,
              testing::Not(HasSubstr("reads it")));
  EXPECT_THAT(run_taut("solve -", "0 0 1 x\n").err, HasSubstr("<stdin>:1: "));
}

class Help : public ProgramTest {};

TEST_F(Help, IsGivenInEveryWay) {
  EXPECT_EQ(run_taut("help").out, run_taut("--help").out);
  for (const char* name : {"solve", "chase", "chase compare", "grid solve", "bug compare"}) {
    SCOPED_TRACE(name);
    const Outcome asked = run_taut(std::string("help ") + name), option = run_taut(std::string(name) + " --help");
    EXPECT_EQ(asked.code, 0);
    EXPECT_EQ(asked.out, option.out);
    EXPECT_THAT(asked.out, HasSubstr(std::string("Usage: taut ") + name));
  }
  const Outcome none = run_taut("help grid frobnicate");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("there is no subcommand 'frobnicate'"));
}

TEST_F(Help, ShowsALineThatCanBeTyped) {
  for (const char* name : {"chase", "chase compare", "chase generate", "chase plane", "bug", "bug compare",
                           "grid solve", "grid compare", "grid heuristics", "grid scen", "grid generate"}) {
    SCOPED_TRACE(name);
    EXPECT_THAT(run_taut(std::string("help ") + name).out, HasSubstr(std::string("\n  taut ") + name + " "));
  }
}

TEST_F(Help, NamesTheVersionEverywhere) {
  const std::string version = run_taut("--version").out;
  EXPECT_THAT(version, StartsWith("taut "));
  for (const char* arguments : {"-V", "solve --version", "grid solve --version", "chase compare -V"})
    EXPECT_EQ(run_taut(arguments).out, version) << arguments;
}

}  // namespace
}  // namespace taut::test
