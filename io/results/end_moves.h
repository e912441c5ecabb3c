// Ends that were moved to the nearest place for the robot, for people and programs.
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/nearest_free.h>
#include <taut/io/results/json.h>

namespace taut {

/// An end as it was given, and the place that it was moved to.
struct EndMove {
  std::string role;  ///< `start`, `goal`
  Point given;
  FreePlace place;
};

/// [{"end", "given": [x, y], "moved_to": [x, y], "distance", "rounding"}, ...]: no place is nearer than distance -
/// rounding.
Json end_moves_json(const std::vector<EndMove>& moves);

/// `start moved 0.03 from (1.5, 1.97)`
std::string end_move_text(const EndMove& move);

/// From each end as given to where it is now, for pictures.
std::vector<Segment> end_move_lines(const std::vector<EndMove>& moves);

}  // namespace taut
