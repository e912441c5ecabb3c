// A disc's path as JSON.
#pragma once

#include <string>

#include <taut/search/arc_search.h>

namespace taut {

/// One JSON object, indented, with a final newline. `verified`: of a path that it passed its check, of "none" that
/// walls and gates prove it. Keys, in this order: program, version, source, status ("found", "none", "unproven",
/// "start_blocked", "goal_blocked"); when found: length, length_interval [lo, hi], verified, bends [[x, y, turn], ...]
/// (exactly what the path is: tangent to these circles, turn 1 counter-clockwise, -1 clockwise, 0 through the point),
/// arcs [[centre x, centre y, from x, from y, to x, to y, turn, sweep in radians], ...] (rounded), points [[x, y], ...]
/// (ends and tangent points, rounded); when blocked: wall [[x1, y1], [x2, y2]], null when the end is outside; always:
/// start, goal, robot.
std::string arc_json(const ArcSearchResult& result, const FreeSpace& space, Point start, Point goal, double radius,
                     bool verified, const std::string& source, const std::string& version);

}  // namespace taut
