// A chase in words.
#pragma once

#include <string>

#include <taut/io/results/path_file.h>
#include <taut/robots/pursuit/chase_run.h>

namespace taut::cli {

/// A line that says what is proven; where somebody could catch the target the columns caught, time, moves and cost.
std::string chase_text(const pursuit::ChaseMap& map, const pursuit::ChaseRun& run);

/// `x,y` at each second that a step ends, a line each: `0 119,45`.
std::string track_text(const pursuit::ChaseMap& map, const pursuit::ChaseRun& run);

/// The same, with a column `second`; coordinates as in the map.
PathToWrite track_path(const pursuit::ChaseMap& map, const pursuit::ChaseRun& run);

/// Of the best plan when the planner is stopped; empty where there is none.
std::string plan_text(const pursuit::ChaseMap& map, const pursuit::ChasePlan& plan);

}  // namespace taut::cli
