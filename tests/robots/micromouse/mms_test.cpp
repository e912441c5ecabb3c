// The protocol of mms, as its mouse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <taut/robots/micromouse/mms.h>

#include "robots/micromouse/support.h"
#include "support/refusal.h"

namespace taut::test {
namespace {

using micromouse::MmsMouse;
using micromouse::Trial;
using micromouse::TrialStatus;
using testing::HasSubstr;

// Up three, right to the goal, and a dead end below it.
constexpr const char* kMaze =
    "o---o---o\n"
    "|     G |\n"
    "o   o   o\n"
    "|   |   |\n"
    "o   o   o\n"
    "|   |   |\n"
    "o   o---o\n"
    "| S |   |\n"
    "o---o---o\n";

class Mms : public testing::Test {
 protected:
  GridMaze maze = micromouse::drawn(kMaze);
  Trial trial{maze};
  MmsMouse mouse{maze, trial, true};

  std::string ask(const std::string& line) { return mouse.answer(line); }
  std::vector<std::string> ask_all(const std::vector<std::string>& lines) {
    std::vector<std::string> answers;
    for (const std::string& line : lines) answers.push_back(ask(line));
    return answers;
  }
  int steps() const { return static_cast<int>(trial.record().steps.size()); }
};

TEST_F(Mms, SeesTheWallsOfItsOwnCellWithoutAStep) {
  EXPECT_EQ(ask_all({"mazeWidth", "mazeHeight", "wallFront", "wallLeft", "wallRight", "wallBack", "wallFront 1\r"}),
            (std::vector<std::string>{"2", "4", "false", "true", "true", "true", "false"}));
  EXPECT_EQ(steps(), 0);
}

TEST_F(Mms, TakesATurnAlongWithTheMoveThatFollows) {
  EXPECT_EQ(ask_all({"moveForward 3", "turnRight", "wallFront", "moveForward"}),
            (std::vector<std::string>{"ack", "ack", "false", "ack"}));
  EXPECT_EQ(steps(), 2);
  EXPECT_EQ(trial.record().goal_at, 2);
  EXPECT_EQ(ask_all({"turnLeft", "turnLeft", "moveForward"}), (std::vector<std::string>{"ack", "ack", "ack"}));
  EXPECT_EQ(steps(), 4) << "turning around is a step of its own";
}

TEST_F(Mms, CrashesWhereAWallEndsTheMove) {
  EXPECT_EQ(ask("moveForward 4"), "crash");
  EXPECT_EQ(trial.pose().cell, (Cell{0, 3}));
  EXPECT_EQ(ask("moveForward 0"), "crash");
  EXPECT_EQ(ask("moveForward x"), "crash");
  EXPECT_EQ(steps(), 2);
}

TEST_F(Mms, BeginsRun2WithTheButton) {
  EXPECT_EQ(ask("wasReset"), "false");
  ask_all({"moveForward 3", "turnRight", "moveForward"});
  EXPECT_EQ(ask_all({"wasReset", "ackReset", "wasReset"}), (std::vector<std::string>{"true", "ack", "false"}));
  EXPECT_EQ(trial.run(), 2);
  EXPECT_EQ(ask("wallFront"), "false") << "it looks north again";
  ask_all({"moveForward 3", "turnRight", "moveForward"});
  EXPECT_EQ(trial.record().status, TrialStatus::finished);
  EXPECT_EQ(trial.record().run1, 3);
  EXPECT_EQ(trial.record().run2, 2);
}

TEST_F(Mms, BeginsRun2BackAtTheStartLookingWhereItLooks) {
  ask_all({"moveForward 3", "turnRight", "moveForward", "turnRight", "turnRight", "moveForward", "turnLeft",
           "moveForward 3"});
  EXPECT_EQ(trial.run(), 2);
  EXPECT_EQ(ask("wallFront"), "true") << "it looks south";
  ask_all({"turnRight", "turnRight", "moveForward 3", "turnRight", "moveForward"});
  EXPECT_EQ(trial.record().status, TrialStatus::finished);
  EXPECT_EQ(trial.record().run2, 2);
}

TEST_F(Mms, NeverHearsOfAButtonThatNobodyPresses) {
  MmsMouse alone(maze, trial, false);
  for (const char* line : {"moveForward 3", "turnRight", "moveForward"}) alone.answer(line);
  EXPECT_EQ(alone.answer("wasReset"), "false");
  EXPECT_EQ(alone.answer("ackReset"), "ack");
}

TEST_F(Mms, CountsAsMmsDoes) {
  EXPECT_EQ(ask_all({"getStat score", "getStat best-run-turns", "getStat total-distance"}),
            (std::vector<std::string>{"2000", "-1", "0"}));
  ask_all({"moveForward 3", "turnRight", "moveForward"});
  EXPECT_EQ(ask_all({"getStat total-distance", "getStat total-effective-distance", "getStat best-run-turns",
                     "getStat best-run-effective-distance", "getStat score"}),
            (std::vector<std::string>{"4", "3.5", "1", "3.5", "4.95"}));
}

TEST_F(Mms, KeepsWhatTheRobotWritesAndIgnoresTheRest) {
  EXPECT_EQ(ask_all({"setText 1 2 twelve letters", "setColor 1 2 r", "setWall 0 0 n", "hello", "", "setText 7 7 out"}),
            (std::vector<std::string>(6, "")));
  ASSERT_EQ(mouse.marks().size(), 1U);
  EXPECT_EQ(mouse.marks().at({1, 2}).text, "twelve let");
  EXPECT_EQ(mouse.marks().at({1, 2}).colour, 'r');
  ask_all({"clearAllText", "clearColor 1 2"});
  EXPECT_EQ(mouse.marks().at({1, 2}).text, "");
  EXPECT_EQ(mouse.marks().at({1, 2}).colour, 0);
  EXPECT_EQ(steps(), 0);
}

TEST_F(Mms, RefusesWhatTheseRulesDoNotKnow) {
  EXPECT_THAT(refusal_of([&] { ask("moveForwardHalf"); }), HasSubstr("whole cells"));
  EXPECT_THAT(refusal_of([&] { ask("turnLeft45"); }), HasSubstr("quarter turns"));
  EXPECT_THAT(refusal_of([&] { ask("wallFront 3"); }), HasSubstr("its own cell"));
  EXPECT_THAT(refusal_of([&] { ask("ackReset"); }), HasSubstr("after it has reached the goal"));
}

}  // namespace
}  // namespace taut::test
