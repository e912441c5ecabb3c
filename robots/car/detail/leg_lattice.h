// The lattice that a general car is planned on. Private.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/robots/car/detail/prepared_leg.h>

namespace taut::car::detail {

/// Positions are multiples of `step`, a power of two, so that they are doubles; headings multiples of `stride`.
struct LegLattice {
  double step = 0;
  int stride = 1;  ///< divides 16

  bool holds(const LatticePose& pose) const;
};

/// A leg from one node to another, wherever the first one is.
struct Primitive {
  PreparedLeg leg;  ///< from (0, 0)
  int di = 0, dj = 0;
};

/// Of each heading (index heading / stride) its primitives: straight ahead by the least multiple of the step, where
/// that is short; for each turn by 1, 2, 4, ... strides up to 90 degrees to either side the shortest few legs; and all
/// that backward where the car may. Turned by 90 degrees the set is the same.
std::vector<std::vector<Primitive>> primitives(const LegLattice& lattice, const CarShape& shape);

/// The shortest few drivable legs for each heading and gear from a pose off the lattice to nodes around it.
std::vector<Leg> legs_onto(const LegLattice& lattice, const CarShape& shape, const LatticePose& from);

/// The drivable legs, forward and backward, from a pose to the point with one of the headings.
std::vector<Leg> legs_to(const CarShape& shape, const LatticePose& from, Point to, const std::vector<int>& headings);

}  // namespace taut::car::detail
