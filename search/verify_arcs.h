// The check of a disc's path that shares nothing with its planner.
#pragma once

#include <taut/roadmaps/gates.h>
#include <taut/search/arc_path.h>
#include <string>

namespace taut {

/// What the check says.
struct ArcVerdict {
  bool valid = false;
  std::string reason;  ///< empty when valid, else one line: `leg 3 comes too near the wall (3, 0) to (3, 5)`
};

/// Does the path lead from `from` to `to` with a distance >= path.radius from every wall? Exact where walls are
/// concerned.
///
///  1. The path is taken as its bends say. Tangent points are numbers a + b sqrt(c) with rational a, b, c; each is
///     checked to be one. Every leg is measured against every wall by squared distances in that field; walls farther
///     away than doubles can err are skipped.
///  2. An arc must not exceed 180 degrees. Both its ends being far enough from a wall, it comes too near iff it passes
///     the direction of the wall's point nearest to its centre, at less than 2r. That is asked on both sides of a
///     rational direction in its middle.
///  3. Neither legs nor arcs may cross an opening: legs exactly, arcs by 512-bit numbers. Touching the end of an
///     opening is not looked into.
///  4. The claimed length must meet the one that the bends give in doubles, within 1e-9 of it.
/// O(pieces * constraints).
ArcVerdict verify_arcs(const ArcPath& path, const Gates& gates, Point from, Point to);

}  // namespace taut
