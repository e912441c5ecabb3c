// The contest: two runs of one robot in one maze, by the rules, with a record of every step.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <taut/robots/micromouse/robot.h>
#include <taut/robots/micromouse/wall_map.h>

namespace taut::micromouse {

/// What was wrong with an action. It is scored as the rules say; this names it.
enum class Offence {
  none,
  early_reset,  ///< before the goal was reached: the step is wasted
  late_reset,   ///< in run 2: the step is wasted
  rotation,     ///< neither -90, 0 nor 90: nothing turned
  movement,     ///< beyond 3 cells: cut to 3
};
/// In words, for messages.
std::string_view name(Offence offence);

/// One step, enough to replay it.
struct Step {
  int run = 1;  ///< 1 or 2
  MousePose before{};
  SensorReading sight{};  ///< what the robot saw before it chose
  Action action{};
  MousePose after{};     ///< after the reset: the start, heading north
  int moved = 0;         ///< cells, negative backwards
  bool blocked = false;  ///< a wall cut the move short
  bool in_goal = false;  ///< the step ended in the goal
  Offence offence = Offence::none;
  std::vector<WallSeen> seen{};  ///< what `sight` told that was not known before
  std::vector<WallSeen> felt{};  ///< what the move told beyond that
};

/// How a trial stands or ended.
enum class TrialStatus {
  running,
  finished,       ///< both runs reached the goal
  no_goal,        ///< the steps ran out in run 1, goal not reached
  no_reset,       ///< the steps ran out in run 1 after the goal had been reached
  no_second_run,  ///< the steps ran out in run 2
  no_route,       ///< the maze has no way from start to goal: not a step was taken
};
/// In words, for messages.
std::string_view name(TrialStatus status);

/// A trial as it went, enough to replay and score it.
struct Record {
  Task task;
  TrialStatus status = TrialStatus::running;
  std::vector<Step> steps;
  int run1 = 0;  ///< steps of run 1, the reset included
  int run2 = 0;
  std::optional<int> goal_at{};  ///< steps of run 1 until the goal was first reached

  /// run 2 + run 1 / 30 in thirtieths, exactly; nothing unless finished.
  std::optional<int> thirtieths() const;
  std::optional<double> score() const;
};

/// A trial that is driven from outside, one action a time.
///
///  1. Step: turn; move cell by cell until a wall stops it; the step counts whatever came of it.
///  2. The goal counts at the end of a step only.
///  3. The reset in run 1 costs a step. Once the goal has been reached it puts the robot at the start, heading north,
///     and begins run 2; before that, and in run 2, it does nothing else.
///  4. Run 2 ends with the first step that ends in the goal. All is over after task().max_steps steps of both runs.
/// Nothing an action says makes it fail. O(side) a step.
class Trial {
 public:
  /// Throws InputError as task_of.
  explicit Trial(const GridMaze& maze, int max_steps = kMaxSteps);

  const Task& task() const { return record_.task; }
  bool over() const { return record_.status != TrialStatus::running; }
  int run() const { return run_; }
  const MousePose& pose() const { return pose_; }
  SensorReading sight() const;

  /// Precondition: !over().
  const Step& act(const Action& action);

  const Record& record() const { return record_; }
  /// What all sights and moves so far tell, those of the present pose not yet included.
  const WallMap& known() const { return known_; }

 private:
  void turn_and_move(Step& step);
  void close(const Step& step);

  GridMaze maze_;
  Record record_;
  WallMap known_;
  MousePose pose_;
  int run_ = 1;
};

/// What run 1 of a record told of the walls.
WallMap known_after_run1(const Record& record);

/// Lets a robot run the whole trial.
Record run_trial(const GridMaze& maze, Robot& robot, int max_steps = kMaxSteps);

}  // namespace taut::micromouse
