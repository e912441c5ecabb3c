#include <taut/robots/micromouse/mapping_robot.h>

#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse {

Action MappingRobot::next(const SensorReading& sight) {
  if (run_ == 1 && last_.reset && goal_reached_) {
    run_ = 2;
    odometer_.restart();
  }
  odometer_.sense(sight);
  learned_ = false;
  if (steps_ > 0 && !last_.reset) learned_ = !map_.move(odometer_.previous(), last_, pose()).empty();
  if (!map_.see(pose(), sight).empty()) learned_ = true;
  if (run_ == 1 && steps_ > 0 && !last_.reset && task_.in_goal(pose().cell)) goal_reached_ = true;
  last_ = run_ == 1 ? explore() : race();
  odometer_.act(last_);
  ++steps_;
  return last_;
}

Action MappingRobot::race() {
  const StepField certain(map_.certain(), task_.goal);
  const StepField possible(map_.possible(), task_.goal);
  const StepField& field = certain.reached(pose().cell) ? certain : possible;
  if (!field.reached(pose().cell)) return {};
  for (const Cell c : one_step_from(map_.certain(), pose().cell))
    if (field(c) == field(pose().cell) - 1) return action_towards(pose(), c);
  return {};
}

}  // namespace taut::micromouse
