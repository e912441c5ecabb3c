// What `taut mouse speed` says of a maze: runs, and times that none beats.
#pragma once

#include <optional>

#include <taut/robots/micromouse/free_speed_run.h>
#include <taut/robots/micromouse/speed_bound.h>

namespace taut::micromouse {

struct SpeedRuns {
  SpeedRun fastest;   ///< of free_speed_run()
  SpeedRun steady;    ///< of speed_run(): each turn at its one speed
  SpeedRun shortest;  ///< the fastest if it has the fewest cells; else speed_run() with that aim, at_full_speed()
  double bound = 0;   ///< s; no run on such lines takes less, at whatever speeds
  SpeedBound any_curve;
};

/// Nothing when there is no way. Throws InputError as speed_run().
std::optional<SpeedRuns> speed_runs(const GridMaze& maze, const SpeedModel& model = {});

}  // namespace taut::micromouse
