// The check of a path that shares nothing with the planners.
#pragma once

#include <optional>
#include <string>

#include <taut/geometry/free_space.h>
#include <taut/search/path.h>

namespace taut {

/// What verify() found.
struct Verdict {
  bool valid = false;
  /// Empty when valid, else one line: `leg 3, (1, 2) to (4, 2), crosses the wall (3, 0) to (3, 5)`.
  std::string reason{};
  std::size_t leg = 0;            ///< the first offending leg, from 0
  std::optional<Point> at{};      ///< where on it, to the nearest doubles, where a constraint is in the way
  std::uint32_t blocker = kNone;  ///< that constraint, the first that the leg comes to
  /// Least distance of the path to an obstacle, to the nearest double: 0 when it touches, infinite when there is no
  /// obstacle.
  double clearance = 0;
  std::uint32_t nearest = kNone;  ///< the constraint where that is
};

/// Is `path` a path a robot of vanishing radius can follow in `space`, from `from` to `to` (or into the goal room: to a
/// point inside one of its boxes, or to one on its rim from which the way towards the middle begins free)?
///
/// Uses the constraints only, never the triangulation: every leg against every constraint (through an r-tree over the
/// legs), with exact predicates; where the path touches constraints, the side on which it passes is carried along, so
/// that a path that slips through a joint of two walls, or changes sides of a wall it runs along, is refused. Also
/// refused: no points, a coordinate that is not finite, a start or end other than given, a point inside an obstacle or
/// outside the world, a claimed length that is not the exact length of the points. Repeated points are allowed. O((n +
/// k) log k + contacts).
Verdict verify(const Path& path, const FreeSpace& space, Point from, const Goal& to);

/// The same verdict without `nearest`, for a path just found. Where the space is made of cells, the constraints are
/// read from those that each leg passes: O(cells along the path), and the space needs no triangles. A path that it
/// refuses is put before verify(), which names what is in the way.
Verdict verify_along(const Path& path, const FreeSpace& space, Point from, const Goal& to);

}  // namespace taut
