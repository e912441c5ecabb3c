// Going straight, between places that may be rational.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/triangulation.h>
#include <taut/robots/bug/detail/rational.h>

namespace taut::bug::detail {

/// Where the robot stands.
struct Stand {
  enum class Kind {
    open,  ///< in a free triangle, or on an unconstrained side of it
    side,  ///< on a constrained side of triangle t, not at its ends
    vertex
  };
  Kind kind = Kind::open;
  std::uint32_t t = kNone;
  int i = 0;                     ///< side: the corner opposite to it
  std::uint32_t sector = kNone;  ///< vertex
  ExactPoint at{Point{}};
};

/// A straight piece of a walk: the triangles passed, in order, up to a vertex or to the end.
struct Piece {
  std::vector<std::uint32_t> triangles;
  std::optional<Point> to;  ///< a vertex; nothing for the last piece
};

struct Walk {
  bool reached = false;
  Stand end;  ///< at the goal; when not reached on a side or at a vertex, where the way is blocked
  std::vector<Piece> pieces;
};

/// Does the way from a place on a contour to the goal lead off the contour at once? Exact. Precondition: it is not the
/// goal.
bool leads_off(const Triangulation& tri, const Stand& stand, Point goal);
/// May it begin along the contour, too?
bool is_open(const Triangulation& tri, const Stand& stand, Point goal);

/// The walk from `stand` straight to the goal, as far as it gets. `from`, with the goal, is the line that it goes
/// along: a point on it no nearer to the goal than the stand, exactly. Exact. Precondition: the stand is not the goal.
Walk walk_to(const Triangulation& tri, const Stand& stand, const ExactPoint& from, const Spot& goal);

}  // namespace taut::bug::detail
