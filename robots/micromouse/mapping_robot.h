// A robot that keeps a map and knows where it is: what remains is how to explore.
#pragma once

#include <taut/robots/micromouse/robot.h>
#include <taut/robots/micromouse/wall_map.h>

namespace taut::micromouse {

/// Base of robots that map. It follows its own pose, learns from every sight and move, and turns from run 1 to run 2
/// when its reset is granted. A subclass answers what to do next in run 1; kReset counts only once the goal has been
/// reached.
class MappingRobot : public Robot {
 public:
  explicit MappingRobot(const Task& task) : task_(task), map_(task), odometer_(task) {}
  Action next(const SensorReading& sight) final;

  const Task& task() const { return task_; }
  const WallMap& map() const { return map_; }

 protected:
  /// Run 1.
  virtual Action explore() = 0;
  /// Run 2: the first step of a shortest route on what is surely open; where there is none, on what may be.
  virtual Action race();

  const MousePose& pose() const { return odometer_.pose(); }
  bool goal_reached() const { return goal_reached_; }
  int steps_taken() const { return steps_; }
  int steps_left() const { return task_.max_steps - steps_; }
  /// Whether the last sight or move told anything new.
  bool learned() const { return learned_; }

 private:
  Task task_;
  WallMap map_;
  Odometer odometer_;
  Action last_{};
  int run_ = 1;
  int steps_ = 0;
  bool goal_reached_ = false;
  bool learned_ = false;
};

}  // namespace taut::micromouse
