// Where gates cross openings. Private.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <cstdint>
#include <vector>

#include <taut/geometry/exact/exact_point.h>
#include <taut/roadmaps/exact/exact_gates.h>

namespace taut::detail {

/// A gate passes through an opening, or through its end.
struct GateCrossing {
  Rational from_end;              ///< how far along the gate: 0 at its end, 1 at its foot
  std::uint32_t opening = kNone;  ///< the constraint, crossed inside
  Rational along;                 ///< where, from its a to its b
  std::uint32_t vertex = kNone;   ///< or the vertex that is passed
  std::uint32_t stop = kNone;     ///< for who numbers crossings
};

/// Of each gate, from its end to its foot; a place once. Exact.
std::vector<std::vector<GateCrossing>> gate_crossings(const ExactGates& gates);

/// a + t (b - a).
ExactPoint point_along(const Segment& c, const Rational& t);

/// The t of p's foot on the line of c.
Rational place_along(const Segment& c, const ExactPoint& p);
inline Rational place_along(const Segment& c, Point p) { return place_along(c, ExactPoint(p)); }

/// Where p q meets c other than in p and q. Several: a segment along c passes both ends.
void append_crossings(const ExactPoint& p, const ExactPoint& q, const WallIndex& walls, std::uint32_t c,
                      std::vector<GateCrossing>& to);

}  // namespace taut::detail
