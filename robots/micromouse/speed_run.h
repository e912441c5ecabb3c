// The fastest way through a known maze, under a time model, with smooth turns and diagonals.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <taut/geometry/grid_maze.h>
#include <taut/geometry/point.h>
#include <taut/robots/micromouse/speed_model.h>

namespace taut::micromouse {

/// A point of the half-cell lattice: (2x + 1, 2y + 1) is the middle of cell (x, y), one even coordinate the middle of a
/// wall.
struct Spot {
  int x = 0;
  int y = 0;
  friend auto operator<=>(const Spot&, const Spot&) = default;
};

/// Eighths of a turn clockwise from north: 0 north, 1 north-east, ..., 7 north-west.
using Eighth = std::uint8_t;

/// A straight, a smooth turn, or a turn on the spot.
struct Drive {
  enum class Kind : std::uint8_t { straight, turn, pivot };
  Kind kind = Kind::straight;
  Turn turn = Turn::small_90;  ///< of a turn
  Spot from{};
  Spot to{};
  Eighth heading = 0;  ///< on entering
  Eighth after = 0;    ///< on leaving
  double speed_in = 0;
  double speed_out = 0;  ///< m/s
  double seconds = 0;
  double metres = 0;
};

/// `straight`, `diagonal`, the name of the turn, `pivot`.
std::string_view name(const Drive& drive);

/// A run as it is driven. Seconds and metres are the sums over the drives.
struct SpeedRun {
  std::vector<Drive> drives;  ///< each begins where, as and as fast as the one before ends
  std::vector<Cell> cells;    ///< passed through, start and goal included
  double seconds = 0;
  double metres = 0;
};

/// What counts first.
enum class Aim {
  fastest,      ///< least time, of those the fewest cells
  fewest_cells  ///< the shortest as cells count, of those the fastest
};

/// From standing in the middle of the start, looking north, to standing in the middle of a goal cell.
///  1. Between turns the mouse goes straight, orthogonally along the middles of cells or diagonally through middles of
///     walls, as straight_seconds() has it. Turns are those of Turn, at their one speed. Standing in the middle of a
///     cell it may turn on the spot, so there is a run whenever there is a way.
///  2. It crosses walls in their middles only where they are open; openings of the border count as closed.
///  3. No run of these has less time (Aim::fastest): Dijkstra over (spot, heading, kind of the last turn), an edge
///     being a whole straight and the turn behind it. Times are sums of doubles; among equal ones the lower state wins.
///     Same input, same run.
/// Nothing when there is no way. Throws InputError as task_of, but not for openings of the border. O(states log
/// states), states <= 200 a cell.
std::optional<SpeedRun> speed_run(const GridMaze& maze, const SpeedModel& model = {}, Aim aim = Aim::fastest);

/// The middle line of a drive in cells, from end to end: arcs as chords, at most `step` cells long.
std::vector<Point> trace(const Drive& drive, double step = 0.05);

}  // namespace taut::micromouse
