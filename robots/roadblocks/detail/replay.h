// A plan of given controls.
#pragma once

#include <optional>
#include <vector>

#include <taut/robots/roadblocks/detail/disc_distance.h>
#include <taut/robots/roadblocks/lattice_planner.h>

namespace taut::roadblocks::detail {

/// From there with these controls, cut off where the goal is reached; nothing when a step is not clear by `slack` or
/// the goal never reached.
std::optional<DrivePlan> replayed(const Pose& from, const std::vector<double>& controls, const Obstacles& obstacles,
                                  double slack);

}  // namespace taut::roadblocks::detail
