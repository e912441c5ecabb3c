// The path of a disc's centre: straight legs and arcs around corners.
#pragma once

#include <vector>

#include <taut/geometry/length.h>
#include <taut/geometry/point.h>

namespace taut {

/// A corner that a path bends around.
struct ArcBend {
  Point corner;
  /// +1: counter-clockwise on the circle of the path's radius around it, -1: clockwise; 0: through the corner itself
  int turn = 0;

  friend bool operator==(const ArcBend&, const ArcBend&) = default;
};

/// A leg or an arc, rounded: its points are off by a few ulp of the coordinates.
struct ArcPiece {
  Point from, to;
  int turn = 0;           ///< 0: a straight leg; else ArcBend::turn
  Point centre;           ///< of an arc
  double from_angle = 0;  ///< of an arc: where it begins, from the x-axis, in radians
  double sweep = 0;       ///< of an arc: 0 to pi radians, in the direction of `turn`
  Interval length;        ///< encloses the exact length
};

/// What a path is, exactly: from start, tangent to each bend's circle in turn, to the goal. Tangent points follow from
/// that; their coordinates are irrational, so pieces() are for eyes and machines and verify_arcs() takes the bends.
struct ArcPath {
  double radius = 0;
  Point start, goal;
  std::vector<ArcBend> bends;  ///< none: straight to the goal
  /// Encloses the exact length: legs are square roots, arcs the radius times an angle, which is transcendental. Its
  /// width is about 1e-15 of the length for each piece.
  Interval length;

  double value() const { return length.lo + (length.hi - length.lo) / 2; }
};

/// Legs and arcs in order, alternating; a leg of length 0 and no leg at all between two corners passed straight are
/// possible. Precondition: consecutive corners differ and have the tangent.
std::vector<ArcPiece> pieces(const ArcPath& path);

/// The sum of the pieces' lengths.
Interval length_of(const std::vector<ArcPiece>& pieces);

/// Points on the path, its ends and all tangent points among them, so that straight legs between them are no farther
/// than `tolerance` > 0 from it (or 65536 to an arc). Chords of arcs come that much nearer to walls than the path.
std::vector<Point> sampled(const ArcPath& path, double tolerance);

}  // namespace taut
