// Drives of cars, as JSON.
#pragma once

#include <optional>

#include <taut/io/results/json.h>
#include <taut/robots/car/car_planner.h>
#include <taut/robots/roadblocks/drive.h>

namespace taut {

/// One sample of a roadblock map driven.
struct RoadblockDrive {
  roadblocks::Sample sample;
  roadblocks::Drive drive;
  double first_plan = 0, slowest_replan = 0;  ///< CPU milliseconds
  std::optional<bool> policy_exact{};         ///< of planners with a policy

  std::size_t steps() const { return drive.controls.size(); }
  bool reached() const { return drive.outcome == roadblocks::Outcome::reached; }
};

/// `sample`, `open` (bits, as in the map), `reached`, `outcome`, `steps`, `collisions`, `replans`, `first_plan_ms`,
/// `slowest_replan_ms`; `policy_exact` where it is known; `controls` on request.
Json roadblock_drive_json(const RoadblockDrive& drive, const roadblocks::Course& course, bool controls);

/// `reached`, `car`, `lattice`; when found `length`, `lower_bound`, `weight`, `collisions`, `verified`, `reversals`,
/// `start` and `end` [x, y, degrees], `segments` (straight pieces and arcs, lengths negative in reverse), `legs` (exact
/// poses). Precondition: what was found has passed car::verify_drive().
Json car_drive_json(const car::PlannedDrive& drive, const car::CarShape& shape, double weight);

}  // namespace taut
