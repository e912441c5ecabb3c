#include <taut/robots/micromouse/detail/flood_step.h>

#include <algorithm>

#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse::detail {

Action flood_step(const WallMap& map, const Task& task, const MousePose& pose) {
  const StepField to_goal(map.possible(), task.goal);
  if (!to_goal.reached(pose.cell)) return {90, 0};
  const auto next = one_step_from(map.certain(), pose.cell);
  for (const Cell c : next)
    if (to_goal(c) == to_goal(pose.cell) - 1) return action_towards(pose, c);
  // The way leads through a wall not yet seen: it is behind, or further along a corridor than a step.
  const auto least =
      std::min_element(next.begin(), next.end(), [&](Cell a, Cell b) { return to_goal(a) < to_goal(b); });
  if (map.state(pose.cell, opposite(pose.heading)) == WallState::unknown || least == next.end()) return {90, 0};
  return action_towards(pose, *least);
}

}  // namespace taut::micromouse::detail
