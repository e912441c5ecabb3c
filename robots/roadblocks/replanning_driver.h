// A driver along the plans of any planner.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <taut/robots/roadblocks/lattice_planner.h>

namespace taut::roadblocks {

/// A plan, or why there is none.
struct Attempt {
  std::optional<DrivePlan> plan;
  bool proven_none = false;  ///< without a plan: there is none; else the planner gave up
};

/// A planner to which the roadblocks it is told are closed and all others open.
using Planning = std::function<Attempt(const Pose& from, RoadblockSet closed)>;

/// Takes unknown roadblocks for open, and plans again whenever one shows closed, on its way or not.
std::unique_ptr<Driver> replanning_driver(Planning planning);

}  // namespace taut::roadblocks
