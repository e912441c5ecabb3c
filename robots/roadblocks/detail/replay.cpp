#include <taut/robots/roadblocks/detail/replay.h>

namespace taut::roadblocks::detail {

std::optional<DrivePlan> replayed(const Pose& from, const std::vector<double>& controls, const Obstacles& obstacles,
                                  double slack) {
  DrivePlan plan;
  Pose pose = from;
  for (const double control : controls) {
    const Pose to = stepped(pose, control);
    if (!obstacles.is_clear(pose, control, to, slack)) return std::nullopt;
    plan.controls.push_back(control);
    plan.poses.push_back(pose = to);
    if (at_goal(pose, obstacles.course(), -kMargin)) return plan;
  }
  return std::nullopt;
}

}  // namespace taut::roadblocks::detail
