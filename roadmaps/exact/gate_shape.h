// The exact side of a gate: its width, its foot, what its disc touches.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <optional>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/point.h>

namespace taut {

/// From a point to the nearest point of a segment. `facing` is one point when the foot is known exactly.
struct GateShape {
  Point end;
  Segment facing;

  bool exact() const { return facing.a == facing.b; }
};

/// The shape from p to the inside of c; nothing when the foot is an end of c. Exact. A foot on an axis-parallel segment
/// is a point.
std::optional<GateShape> gate_to_inside(Point p, const Segment& c);

/// |end - foot|^2.
Rational squared_width(const GateShape& shape);

ExactPoint exact_foot(const GateShape& shape);

/// The foot to the nearest doubles.
Point nearest_foot(const GateShape& shape);

/// The sign of (x - p) (q - p). Exact.
int dot_sign(Point p, Point q, Point x);

/// Which side of the line a -> b the foot is on, as orientation(a, b, foot) says. Exact.
int foot_orientation(Point a, Point b, const GateShape& shape);

/// Which side of the line end -> foot p is on; +1 or -1 may be swapped, alike for all p. Exact.
int side_of_gate(const GateShape& shape, Point p);

/// Does `wall`, which has neither the end nor the foot of the gate on it, meet the closed disc on the gate as diameter?
/// Exact.
bool disc_meets(const GateShape& shape, const Segment& wall);

/// Is `wall` nearer to the gate's foot (to its end, when `to_end`) than the gate is long? Exact.
bool nearer_than_gate(const GateShape& shape, bool to_end, const Segment& wall);

/// Does `wall`, one end of which is `at`, enter the disc on the gate there? `at` is the gate's end, or its foot when
/// that is exact. Exact.
bool disc_entered(const GateShape& shape, Point at, const Segment& wall);

}  // namespace taut
