// A plan made shorter by continuous controls.
#pragma once

#include <taut/robots/roadblocks/detail/disc_distance.h>
#include <taut/robots/roadblocks/lattice_planner.h>

namespace taut::roadblocks::detail {

/// Replaces stretches of the plan by fewer steps: three arcs whose controls, found by Newton's method, end in the very
/// same pose (within 1e-11), or, at the end, a pose that covers the goal. What is returned has been replayed from the
/// first step on, clear by `slack` at each; it is never longer. Deterministic: stretches are tried in a fixed order,
/// long ones first.
DrivePlan with_shortcuts(const Pose& from, const DrivePlan& plan, const Obstacles& obstacles, double slack);

}  // namespace taut::roadblocks::detail
