// taut mouse serve, as its users run it.
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
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class MouseServe : public ProgramTest {};

TEST_F(MouseServe, SpeaksALineAStepAndEndsWithTheScore) {
  // Up to the goal, reset, up again.
  const std::string bend = folder.file("bend", kBend);
  const Outcome run = run_taut("mouse serve " + bend, "0 1\n90 1\nreset\n0 1\n90 1\n");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "0 1 0\n0 0 1\n0 0 0\n0 1 0\n0 0 1\nscore 2.100 run1 3 run2 2\n");
}

TEST_F(MouseServe, NamesTheLineThatIsGarbage) {
  const std::string serve = "mouse serve " + data_file("mouse_12.cells");
  const auto expect_error = [&](const std::string& input, const char* says) {
    const Outcome run = run_taut(serve, input);
    EXPECT_EQ(run.code, 3) << input;
    EXPECT_THAT(run.err, HasSubstr(says));
    EXPECT_EQ(lines_of(run.err).size(), 1U) << run.err;
  };
  expect_error("", "<stdin>:1: ends after step 0");
  expect_error("0 1\n\n# mine\n", "<stdin>:4: ends after step 1");
  expect_error("0 1\n0 x\n", "<stdin>:2: this is neither");
  expect_error("0\n", "<stdin>:1: this is neither");
  expect_error("0 1 2\n", "<stdin>:1: this is neither");
  expect_error("reset now\n", "<stdin>:1: this is neither");
  expect_error("0 99999999999999999999\n", "<stdin>:1: this is neither");
  expect_error(std::string(5000, 'a'), "<stdin>:1: the line is too long");
}

TEST_F(MouseServe, CountsStepsThatBreakTheRulesAndNamesThem) {
  const Outcome run = run_taut("mouse serve --max-steps 4 " + folder.file("bend", kBend), "45 0\n0 9\nreset\n90 -1\n");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.out, EndsWith("failed the steps ran out before run 1 reached the goal\n"));
  EXPECT_THAT(run.err, HasSubstr("<stdin>:1: rotation other than -90, 0, 90"));
  EXPECT_THAT(run.err, HasSubstr("<stdin>:2: movement beyond 3 cells"));
  EXPECT_THAT(run.err, HasSubstr("<stdin>:3: reset before the goal"));
}

TEST_F(MouseServe, GreetsWhenAsked) {
  const Outcome run = run_taut("mouse serve --hello " + folder.file("bend", kBend), "0 1\n");
  EXPECT_THAT(run.out, StartsWith("maze 2 2 0 0 1000\ngoal 1 1\n0 1 0\n"));
}

TEST_F(MouseServe, ReplaysABuiltInExplorerToTheSameScore) {
  const json own = json::parse(run_taut("mouse run --quick --json - " + data_file("mouse_16.maz")).out)["result"];
  std::string actions;
  for (const json& step : own["steps"])
    actions += step.contains("reset") ? "reset\n"
                                      : std::to_string(step["action"][0].get<int>()) + " " +
                                            std::to_string(step["action"][1].get<int>()) + "\n";
  const Outcome served = run_taut("mouse serve " + data_file("mouse_16.maz"), actions);
  EXPECT_EQ(served.code, 0) << served.err;
  EXPECT_THAT(served.out, HasSubstr("run1 " + std::to_string(own["run1"].get<int>()) + " run2 " +
                                    std::to_string(own["run2"].get<int>())));
}

// A robot that keeps the wall to its left, in Python: twice.
constexpr const char* kWallFollower = R"(
import sys
def line():
    text = sys.stdin.readline()
    if not text or text[0] in "sf":
        sys.stderr.write(text)
        sys.exit(0)
    return [int(word) for word in text.split()]
goal, cell, heading, run = {(1, 1)}, (0, 0), 0, 1
while True:
    left, front, right = line()
    if cell in goal and run == 1:
        print("reset", flush=True)
        cell, heading, run = (0, 0), 0, 2
        continue
    turn = -90 if left else 0 if front else 90
    go = 1 if left or front or right else 0
    heading = (heading + turn // 90) % 4
    dx, dy = [(0, 1), (1, 0), (0, -1), (-1, 0)][heading]
    cell = (cell[0] + go * dx, cell[1] + go * dy)
    print(turn, go, flush=True)
)";
TEST_F(MouseServe, LetsAProgramInAnotherLanguageBeTheRobot) {
  if (run_script("command -v python3 >/dev/null && command -v mkfifo >/dev/null").code != 0)
    GTEST_SKIP() << "no python3";
  const std::string robot = folder.file("robot.py", kWallFollower), bend = folder.file("bend", kBend);
  const std::string back = in_folder("back");
  const Outcome run = run_script("mkfifo " + back + " && \"$taut\" mouse serve " + bend + " < " + back + " | python3 " +
                                 robot + " > " + back);
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("score 2.100 run1 3 run2 2"));
}

TEST_F(MouseServe, OutlivesARobotThatGoesAway) {
  const Outcome run = run_script("(printf '0 1\\n'; sleep 0.3; printf '0 1\\n0 1\\n') | { \"$taut\" mouse serve " +
                                 data_file("mouse_12.cells") + "; echo code $? >&2; } | head -n 1");
  EXPECT_THAT(run.err, ContainsRegex("code [34]"));
}

}  // namespace
}  // namespace taut::test
