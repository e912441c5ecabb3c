// Runs of planners as bytes, for shards.
#pragma once

#include <string>
#include <string_view>

#include <taut/search/planners.h>

namespace taut::cli {

/// All but the planner itself and the roadmaps.
std::string packed_runs(const PlannerRuns& runs);
/// Throws InputError with `name` where the bytes are none.
PlannerRuns unpacked_runs(const Planner& planner, std::string_view bytes, const std::string& name);

}  // namespace taut::cli
