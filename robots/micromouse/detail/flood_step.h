// The step of a flood fill. Private.
#pragma once

#include <taut/robots/micromouse/wall_map.h>

namespace taut::micromouse::detail {

/// Along the fewest steps to the goal, unknown walls open. Cells to stop in are reached by known passages alone; a turn
/// on the spot where the way leads through a wall not yet seen.
Action flood_step(const WallMap& map, const Task& task, const MousePose& pose);

}  // namespace taut::micromouse::detail
