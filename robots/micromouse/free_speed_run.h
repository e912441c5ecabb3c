// The fastest run with turns at any speeds that they allow, and a time that none beats.
#pragma once

#include <optional>

#include <taut/geometry/grid_maze.h>
#include <taut/robots/micromouse/speed_run.h>

namespace taut::micromouse {

/// The drives of a run as fast as the model allows: nowhere slower than it need be, on the same line.
///  1. On straights, and on the straight ends of turns of 45, 135 and 180, speeds are those of the ramps. Where a turn
///     bends its speed is the greatest allowed, not the only one; the mouse may enter slower, speed up and brake there,
///     as hard as either ramp allows. A turn with a time of its own takes that, and begins and ends no faster than at
///     its speed.
///  2. It stands at the ends of the run and for turns on the spot.
///  3. No drive of this line under 1 and 2 takes less, and so not the run itself either. O(drives).
SpeedRun at_full_speed(const SpeedRun& run, const SpeedModel& model = {});

struct FreeSpeedRun {
  SpeedRun run;
  double bound = 0;  ///< s; no run takes less
};

/// From standing in the middle of the start, looking north, to standing in the middle of a goal cell, on the lines of
/// speed_run() at the speeds of at_full_speed().
///  1. `bound` is proven: for whatever lines and speeds. A run is a way in the graph whose nodes are (spot, heading,
///     speed) where turns end and where it stands, whose edges are a straight and the turn behind it. Speeds are put
///     into classes; an edge between two of them costs the least time of any drive whose speeds at its ends are in
///     these. Such a drive is nowhere faster than the fastest one with the classes' greatest speeds as limits, so that
///     one's time is this cost. The shortest way from class to class costs no more than any run takes: it forgets, at
///     each node, where in the class the speed was, and nothing else. Sums are rounded down.
///  2. `run` is the line of that way, or one of speed_run() if this is faster, at full speed: no slower than those of
///     speed_run() with either aim. How far it is above `bound` depends on the width of the classes alone
///     (docs/micromouse.md has figures). Same input, same run.
/// Nothing when there is no way. Throws InputError as speed_run(). A* over nodes: O(cells * classes^2) edges.
std::optional<FreeSpeedRun> free_speed_run(const GridMaze& maze, const SpeedModel& model = {});

}  // namespace taut::micromouse
