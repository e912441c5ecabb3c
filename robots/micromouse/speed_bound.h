// A time that no mouse of a model beats, whatever way it takes and however it turns.
#pragma once

#include <optional>

#include <taut/geometry/grid_maze.h>
#include <taut/robots/micromouse/speed_model.h>

namespace taut::micromouse {

struct SpeedBound {
  double seconds = 0;
  double metres = 0;  ///< the shortest way for a point among walls without thickness
};

/// A lower bound of the time of any drive from standing in the middle of the start to standing in the middle of a goal
/// cell: its middle line may cross the walls' gaps anywhere, in any heading, on any curve (speed_run() knows some
/// curves through their middles), as long as it is never faster than the model's greatest speed, never speeds up or
/// brakes harder than its greatest accelerations. Such a line is as long as the shortest path of a point at least, and
/// a straight of that length takes the least time for it. The length is enclosed, all is rounded down. A model with
/// turns that take less time than length / speed is bounded by its greatest speed alone.
/// Turning costs nothing here, so real times are above: a bound, no estimate (docs/micromouse.md has figures). Nothing
/// when there is no way. Throws InputError as speed_run().
std::optional<SpeedBound> speed_bound(const GridMaze& maze, const SpeedModel& model = {});

}  // namespace taut::micromouse
