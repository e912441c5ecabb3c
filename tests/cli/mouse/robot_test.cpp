// taut mouse serve --robot: programs that are started, and what is left of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/mouse/mazes.h"
#include "support/program_test.h"
#include "support/text.h"

namespace taut::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class MouseRobot : public ProgramTest {
 protected:
  std::string bend = folder.file("bend", kBend);

  Outcome serve(const std::string& robot, const std::string& more = "") {
    return run_taut("mouse serve " + more + " " + bend + " --robot '" + robot + "'");
  }
  /// What the program says in its one line.
  std::string error_of(const std::string& robot, const std::string& more = "") {
    const Outcome run = serve(robot, more);
    EXPECT_EQ(run.code, 3) << robot;
    EXPECT_EQ(run.out, "") << robot;
    EXPECT_EQ(lines_of(run.err).size(), 1U) << run.err;
    return run.err;
  }
};

// Reads a sight, writes an action, and in the end what it was told.
constexpr const char* kScript =
    "for a in \"0 1\" \"90 1\" reset \"0 1\" \"90 1\"; do read s; echo $a; done; read last; echo $last >&2";

TEST_F(MouseRobot, IsReportedAsRunDoes) {
  const Outcome run = serve(kScript, "--svg " + in_folder("runs.svg") + " --animate " + in_folder("film.svg") +
                                         " --json " + in_folder("runs.json"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "score 2.100 run1 3 run2 2\n") << "the robot reads it";
  EXPECT_THAT(run.out, HasSubstr("2 x 2, goal (1,1), a robot of its own"));
  EXPECT_THAT(run.out, HasSubstr("score                 2.100"));
  EXPECT_THAT(run.out, HasSubstr("benchmark 2"));
  EXPECT_THAT(contents(folder / "runs.svg"), HasSubstr("run 2: 2"));
  EXPECT_THAT(contents(folder / "film.svg"), HasSubstr("<animateTransform"));
  EXPECT_EQ(nlohmann::json::parse(contents(folder / "runs.json"))["result"]["run1"], 3);
}

TEST_F(MouseRobot, IsAMmsRobotToo) {
  const char* run1 =
      "ask() { echo $1; read answer; }; run() { ask moveForward; ask turnRight; ask moveForward; }; run; echo setText "
      "1 "
      "1 here; ask ackReset; run";
  const Outcome run = serve(run1, "--mms --svg " + in_folder("runs.svg"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("score                 2.100"));
  EXPECT_THAT(contents(folder / "runs.svg"), HasSubstr(">here<"));
}

TEST_F(MouseRobot, MayEndAtTheGoalWhenItKnowsOfNoSecondRun) {
  const Outcome run = serve("for a in moveForward turnRight moveForward; do echo $a; read b; done", "--mms --quick");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err,
              HasSubstr("ended with exit code 0 after step 2, with the goal reached after 2, without a second"));
  EXPECT_THAT(run.out, HasSubstr("run 1                     2"));
}

TEST_F(MouseRobot, FailsInOneLineThatSaysHow) {
  EXPECT_THAT(error_of("exit 3"), HasSubstr("exit 3:1: ended with exit code 3 after step 0"));
  EXPECT_THAT(error_of("read a; echo 0 1; kill -SEGV $$"), HasSubstr(":2: was ended by signal 11 after step 1"));
  EXPECT_THAT(error_of("echo garbage"), HasSubstr(":1: this is neither"));
  EXPECT_THAT(error_of("yes | tr -d \"\\n\""), HasSubstr(":1: the line is too long"));
  EXPECT_THAT(error_of("sleep 60", "--answer-ms 50"), HasSubstr(":1: no answer within 0.05 s"));
  EXPECT_THAT(error_of("exit 3", "--mms"), HasSubstr("before it reached the goal"));
  EXPECT_THAT(error_of("echo moveForwardHalf; sleep 60", "--mms"), HasSubstr(":1: `moveForwardHalf`: these rules"));
  EXPECT_THAT(serve("/no/such/robot").err, HasSubstr("ended with exit code 127"));
}

// The robot tells its process and that of its child; neither is there afterwards.
TEST_F(MouseRobot, LeavesNothingBehind) {
  const std::string pids = in_folder("pids");
  const std::string robot = "trap \"\" TERM; sleep 60 & echo $$ $! > " + pids + "; wait";
  const auto expect_gone = [&](const char* how) {
    const Outcome alive =
        run_script("for p in $(cat " + pids + "); do grep -v \") Z\" /proc/$p/stat 2>/dev/null; done");
    EXPECT_EQ(alive.out, "") << how;
  };
  EXPECT_EQ(serve(robot, "--answer-ms 300").code, 3);
  expect_gone("no answer in time");
  EXPECT_EQ(serve(robot, "--max-seconds 0.5").code, 4);
  run_script("sleep 0.1");  // killed, and then it is init's to bury them
  expect_gone("stopped by a limit");
}

TEST_F(MouseRobot, SharesNoOptionThatMakesNoSense) {
  EXPECT_EQ(run_taut("mouse serve --svg - " + bend).code, 2);
  EXPECT_EQ(run_taut("mouse serve --mms --hello " + bend).code, 2);
  EXPECT_EQ(run_taut("mouse serve --no-button " + bend).code, 2);
}

TEST_F(MouseRobot, IsAPythonClassByAnAdapter) {
  if (run_script("command -v python3 >/dev/null").code != 0) GTEST_SKIP() << "no python3";
  const std::string examples = TAUT_SOURCE_DIR "/examples/", maze = data_file("mouse_16.maz");
  const Outcome sensors = run_taut("mouse serve --quick --hello " + maze + " --robot 'python3 " + examples +
                                   "next_move.py " + examples + "flooding_robot.py'");
  EXPECT_EQ(sensors.code, 0) << sensors.err;
  EXPECT_THAT(sensors.out, HasSubstr("score                25.067"));
  const Outcome mms =
      run_taut("mouse serve --quick --mms " + maze + " --robot 'python3 " + examples + "mms_flooding_robot.py'");
  EXPECT_EQ(mms.code, 0) << mms.err;
  EXPECT_THAT(mms.out, HasSubstr("run 2 + run 1 / 30"));
}

}  // namespace
}  // namespace taut::test
