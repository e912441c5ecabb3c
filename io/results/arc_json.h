// A disc's path as JSON.
#pragma once

#include <optional>

#include <taut/geometry/free_space.h>
#include <taut/io/results/json.h>
#include <taut/search/arc_pinch.h>
#include <taut/search/arc_search.h>

namespace taut {

/// What there is to say of a disc's way.
struct ArcAnswer {
  Point start, goal;
  double radius = 0;
  ArcSearchResult result{};
  bool verified = false;
  std::optional<double> within{};   ///< rounding_bound, where crossings were rounded
  std::optional<ArcPinch> pinch{};  ///< of the path found, where it passes between two walls
  Barrier barrier{};                ///< why there is none
};

/// One JSON object. Keys, in this order: when found: length, length_interval [lo, hi], optimal (true: no way is
/// shorter by more than the enclosures are wide) or in its place within, as in result_json.h, corners (how many
/// bends), verified, bends [[x, y, turn], ...] (exactly what the path is: tangent to these circles, turn 1
/// counter-clockwise, -1 clockwise, 0 through the point), arcs [[centre x, centre y, from x, from y, to x, to y,
/// turn, sweep in radians], ...] (rounded), points [[x, y], ...] (ends and tangent points, rounded), pinch null or
/// {at: [x, y], posts: [[x, y], [x, y]], width, width_text} (the narrowest gate that the path passes, and where);
/// when none: barrier {walls, gates}; always: start, goal, robot.
Json arc_json(const ArcAnswer& answer);

}  // namespace taut
