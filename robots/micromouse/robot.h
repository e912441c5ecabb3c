// What a program has to be in order to be a micromouse.
#pragma once

#include <taut/robots/micromouse/rules.h>

namespace taut::micromouse {

/// A robot. It is made from a Task and then sees nothing of the maze but its sensors.
///
/// Once a step the trial calls next() with what the sensors give where the robot stands, and does what it answers.
/// Nobody tells the robot where it is, how far a move came, or that a run has ended: all of that follows from Task,
/// sights and its own actions (Odometer does the sum). After kReset in run 1, with the goal reached, the next sight is
/// the one at the start, heading north.
class Robot {
 public:
  Robot() = default;
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;
  virtual ~Robot() = default;

  virtual Action next(const SensorReading& sight) = 0;
};

}  // namespace taut::micromouse
