// Chases as JSON.
#pragma once

#include <taut/io/results/json.h>
#include <taut/robots/pursuit/chase_run.h>

namespace taut::pursuit {

/// `planner` (`online`), `clock`, `free_planning`, `caught`, `time`, `moves`, `cost`, `proven`, `lower_bound`,
/// `costs_rounded`, `planning`, `path` of [second, x, y]; when online `online`: `horizon`, `clairvoyant_cost`, `ratio`.
Json chase_json(const ChaseMap& map, const ChaseRun& run);

/// Of a chase that was stopped while it was planned: `planner`, `clock`, `free_planning`, `caught` (false),
/// `plan_cost`, `lower_bound` and the `path` of the plan, null and empty where there is none yet.
Json chase_plan_json(const ChaseMap& map, const ChaseRequest& request, const ChasePlan& plan);

}  // namespace taut::pursuit
