#include <taut/robots/micromouse/trial.h>

#include <algorithm>
#include <cstdlib>

#include <taut/geometry/expects.h>
#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse {

namespace {

int open_cells(const GridMaze& maze, Cell cell, Side side) {
  int count = 0;
  for (; !maze.wall(cell, side); cell = ahead(cell, side)) ++count;
  return count;
}

}  // namespace

std::string_view name(Offence offence) {
  switch (offence) {
    case Offence::none: return "none";
    case Offence::early_reset: return "reset before the goal";
    case Offence::late_reset: return "reset in run 2";
    case Offence::rotation: return "rotation other than -90, 0, 90";
    case Offence::movement: return "movement beyond 3 cells";
  }
  return "";
}

std::string_view name(TrialStatus status) {
  switch (status) {
    case TrialStatus::running: return "running";
    case TrialStatus::finished: return "finished";
    case TrialStatus::no_goal: return "the steps ran out before run 1 reached the goal";
    case TrialStatus::no_reset: return "the steps ran out in run 1";
    case TrialStatus::no_second_run: return "the steps ran out before run 2 reached the goal";
    case TrialStatus::no_route: return "the maze has no way from start to goal";
  }
  return "";
}

std::optional<int> Record::thirtieths() const {
  if (status != TrialStatus::finished) return std::nullopt;
  return run2 * kExplorationShare + run1;
}

std::optional<double> Record::score() const {
  const auto exact = thirtieths();
  if (!exact) return std::nullopt;
  return static_cast<double>(*exact) / kExplorationShare;
}

Trial::Trial(const GridMaze& maze, int max_steps)
    : maze_(maze),
      record_{task_of(maze, max_steps), {}, {}},
      known_(record_.task),
      pose_{record_.task.start, Side::north} {
  if (!optimum(passages_of(maze), record_.task))
    record_.status = TrialStatus::no_route;
  else if (max_steps <= 0)
    record_.status = TrialStatus::no_goal;
}

SensorReading Trial::sight() const {
  return {open_cells(maze_, pose_.cell, turned(pose_.heading, -1)), open_cells(maze_, pose_.cell, pose_.heading),
          open_cells(maze_, pose_.cell, turned(pose_.heading, 1))};
}

const Step& Trial::act(const Action& action) {
  TAUT_EXPECTS(!over());
  Step step;
  step.run = run_;
  step.before = pose_;
  step.sight = sight();
  step.action = action;
  step.seen = known_.see(pose_, step.sight);
  ++(run_ == 1 ? record_.run1 : record_.run2);
  if (!action.reset)
    turn_and_move(step);
  else if (run_ == 2)
    step.offence = Offence::late_reset;
  else if (!record_.goal_at)
    step.offence = Offence::early_reset;
  else
    pose_ = {record_.task.start, Side::north}, run_ = 2;
  step.after = pose_;
  step.in_goal = record_.task.in_goal(pose_.cell);
  close(step);
  record_.steps.push_back(std::move(step));
  return record_.steps.back();
}

void Trial::turn_and_move(Step& step) {
  const Action& action = step.action;
  if (action.rotation == 90 || action.rotation == -90)
    pose_.heading = turned(pose_.heading, action.rotation / 90);
  else if (action.rotation != 0)
    step.offence = Offence::rotation;
  const int wanted = std::clamp(action.movement, -kLongestMove, kLongestMove);
  if (wanted != action.movement && step.offence == Offence::none) step.offence = Offence::movement;
  const Side side = wanted < 0 ? opposite(pose_.heading) : pose_.heading;
  int moved = 0;
  while (moved < std::abs(wanted) && !maze_.wall(pose_.cell, side)) pose_.cell = ahead(pose_.cell, side), ++moved;
  step.blocked = moved < std::abs(wanted);
  step.moved = wanted < 0 ? -moved : moved;
  step.felt = known_.move(step.before, {0, wanted}, pose_);
}

void Trial::close(const Step& step) {
  const bool moves = !step.action.reset;
  if (run_ == 1 && moves && step.in_goal && !record_.goal_at) record_.goal_at = record_.run1;
  if (run_ == 2 && moves && step.in_goal)
    record_.status = TrialStatus::finished;
  else if (record_.run1 + record_.run2 >= record_.task.max_steps)
    record_.status = run_ == 2         ? TrialStatus::no_second_run
                     : record_.goal_at ? TrialStatus::no_reset
                                       : TrialStatus::no_goal;
}

WallMap known_after_run1(const Record& record) {
  WallMap map(record.task);
  for (const Step& s : record.steps)
    for (const auto* news : {&s.seen, &s.felt})
      for (const WallSeen& w : *news)
        if (s.run == 1) map.learn(w.wall.cell, w.wall.side, w.closed);
  return map;
}

Record run_trial(const GridMaze& maze, Robot& robot, int max_steps) {
  Trial trial(maze, max_steps);
  while (!trial.over()) trial.act(robot.next(trial.sight()));
  return trial.record();
}

}  // namespace taut::micromouse
