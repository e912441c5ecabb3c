#include <taut/robots/micromouse/trial.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/errors.h>
#include <taut/robots/micromouse/certificate.h>

#include "robots/micromouse/support.h"

namespace taut::micromouse {
namespace {

// S at the bottom left, the goal room in the middle.
const std::string kRing =
    "o---o---o---o---o\n"
    "|               |\n"
    "o   o---o---o   o\n"
    "|   |   |   |   |\n"
    "o   o   o   o   o\n"
    "|   |           |\n"
    "o   o---o---o   o\n"
    "|               |\n"
    "o---o---o---o---o\n";

Trial after(const GridMaze& maze, const std::vector<Action>& actions, int max_steps = kMaxSteps) {
  Trial trial(maze, max_steps);
  for (const Action& a : actions) trial.act(a);
  return trial;
}

TEST(MicromouseTrial, SensorsCountOpenCellsToTheNextWall) {
  const GridMaze maze = drawn(kRing);
  EXPECT_EQ(Trial(maze).sight(), (SensorReading{0, 3, 3}));
  EXPECT_EQ(after(maze, {{90, 3}}).sight(), (SensorReading{3, 0, 0}));
}

TEST(MicromouseTrial, TurnsFirstThenMoves) {
  EXPECT_EQ(after(drawn(kRing), {{90, 2}}).pose(), (MousePose{{2, 0}, Side::east}));
}

TEST(MicromouseTrial, MovesBackwardsWithoutTurning) {
  EXPECT_EQ(after(drawn(kRing), {{0, 3}, {0, -2}}).pose(), (MousePose{{0, 1}, Side::north}));
}

TEST(MicromouseTrial, AWallStopsAMoveAndTheStepCounts) {
  const Trial trial = after(drawn(kRing), {{-90, 3}});
  EXPECT_EQ(trial.pose(), (MousePose{{0, 0}, Side::west}));
  EXPECT_TRUE(trial.record().steps[0].blocked);
  EXPECT_EQ(trial.record().run1, 1);
}

TEST(MicromouseTrial, ABackwardMoveThatIsStoppedProvesTheWallBehind) {
  GridMaze maze(4, 4, false);
  maze.set_wall({0, 1}, Side::north, true);  // a wall above (0,1)
  maze.goal = centre_room(4, 4);
  // Up one, then two turns to the right: the wall lies behind.
  const Trial trial = after(maze, {{0, 1}, {90, 0}, {90, 0}, {0, -1}});
  const Step& last = trial.record().steps.back();
  EXPECT_TRUE(last.blocked);
  EXPECT_EQ(last.after.cell, (Cell{0, 1}));
}

TEST(MicromouseTrial, AnOffenceIsScoredAsTheRulesSay) {
  const Trial trial = after(drawn(kRing), {kReset, {45, 1}, {0, 9}, {0, -9}});
  const auto& steps = trial.record().steps;
  EXPECT_EQ(steps[0].offence, Offence::early_reset);
  EXPECT_EQ(steps[1].offence, Offence::rotation);
  EXPECT_EQ(steps[1].after, (MousePose{{0, 1}, Side::north}));
  EXPECT_EQ(steps[2].offence, Offence::movement);
  EXPECT_EQ(steps[2].moved, 2);
  EXPECT_EQ(steps[3].moved, -3);
  EXPECT_EQ(trial.record().run1, 4);
  EXPECT_EQ(trial.run(), 1);
}

TEST(MicromouseTrial, TheGoalCountsOnlyAtTheEndOfAStep) {
  // Along the row of the goal room and out at the other side: three cells, through the room.
  GridMaze maze(4, 4, false);
  maze.goal = centre_room(4, 4);
  const Trial through = after(maze, {{0, 1}, {90, 3}});
  EXPECT_FALSE(through.record().goal_at);
  const Trial into = after(maze, {{0, 1}, {90, 2}});
  EXPECT_EQ(into.record().goal_at, 2);
}

TEST(MicromouseTrial, TheResetCostsAStepAndBeginsRunTwoAtTheStart) {
  GridMaze maze(4, 4, false);
  maze.goal = centre_room(4, 4);
  const Trial trial = after(maze, {{0, 1}, {90, 2}, kReset, kReset, {0, 1}, {90, 2}});
  EXPECT_TRUE(trial.over());
  EXPECT_EQ(trial.record().run1, 3);
  EXPECT_EQ(trial.record().run2, 3);
  EXPECT_EQ(trial.record().steps[3].offence, Offence::late_reset);
  EXPECT_EQ(trial.record().thirtieths(), 3 * 30 + 3);
  EXPECT_TRUE(verify_record(trial.record(), maze));
}

TEST(MicromouseTrial, ThousandStepsHoldForBothRunsTogether) {
  GridMaze maze(4, 4, false);
  maze.goal = centre_room(4, 4);
  EXPECT_EQ(after(maze, {{}, {}}, 2).record().status, TrialStatus::no_goal);
  EXPECT_EQ(after(maze, {{0, 1}, {90, 2}}, 2).record().status, TrialStatus::no_reset);
  EXPECT_EQ(after(maze, {{0, 1}, {90, 2}, kReset, {}}, 4).record().status, TrialStatus::no_second_run);
  EXPECT_EQ(after(maze, {{0, 1}, {90, 2}, kReset, {0, 1}, {90, 2}}, 5).record().status, TrialStatus::finished);
}

TEST(MicromouseTrial, AMazeWithoutARouteEndsBeforeTheFirstStep) {
  GridMaze maze(4, 4, true);
  const Trial trial(maze);
  EXPECT_TRUE(trial.over());
  EXPECT_EQ(trial.record().status, TrialStatus::no_route);
  EXPECT_FALSE(trial.record().score());
}

TEST(MicromouseTrial, AnOpenBorderIsNoMicromouseMaze) {
  GridMaze maze(4, 4, false);
  maze.set_wall({0, 2}, Side::west, false);
  EXPECT_THROW(Trial{maze}, InputError);
}

RC_GTEST_PROP(MicromouseTrial, AnyActionsReplayAndTheOdometerKnowsThePose, ()) {
  const GridMaze maze = generated(6, *rc::gen::inRange<std::uint64_t>(0, 1000));
  Trial trial(maze, 60);
  Odometer odometer(trial.task());
  while (!trial.over()) {
    const bool begins = trial.run() == 2 && trial.record().steps.back().run == 1;
    if (begins) odometer.restart();
    odometer.sense(trial.sight());
    RC_ASSERT(odometer.pose() == trial.pose());
    const Action action{*rc::gen::element(-90, 0, 90, 45), *rc::gen::inRange(-4, 5), *rc::gen::inRange(0, 12) == 0};
    odometer.act(action);
    trial.act(action);
  }
  const Finding finding = verify_record(trial.record(), maze);
  RC_ASSERT(finding.reason == "");
}

RC_GTEST_PROP(MicromouseTrial, ATamperedRecordFails, ()) {
  const GridMaze maze = generated(6, *rc::gen::inRange<std::uint64_t>(0, 1000));
  Trial trial(maze, 20);
  while (!trial.over()) trial.act({*rc::gen::element(-90, 0, 90), *rc::gen::inRange(-3, 4)});
  Record record = trial.record();
  Step& step = record.steps[*rc::gen::inRange<std::size_t>(0, record.steps.size())];
  switch (*rc::gen::inRange(0, 4)) {
    case 0: ++step.sight.front; break;
    case 1: ++step.moved; break;
    case 2: step.after.heading = turned(step.after.heading, 1); break;
    default: --record.run1; break;
  }
  RC_ASSERT(!verify_record(record, maze));
}

}  // namespace
}  // namespace taut::micromouse
