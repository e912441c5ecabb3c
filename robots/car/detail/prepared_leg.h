// A leg made ready to be tested against many walls, wherever it begins. Private.
#pragma once

#include <span>
#include <vector>

#include <taut/robots/car/detail/sweep_test.h>

namespace taut::car::detail {

/// A wall as a leg sees it: relative to where the leg begins.
struct NearWall {
  NearWall(const Segment& wall, Point origin);

  Vec<Approx> a, b;
  Box box;  ///< of a and b, rounding included
  Segment wall;
};

/// Everything about a leg that does not depend on where it begins.
class PreparedLeg {
 public:
  PreparedLeg(const Leg& leg, const CarShape& shape);

  const Leg& leg() const { return leg_; }
  double length() const { return length_; }
  /// Of all that the car sweeps over, relative to the beginning; a little too large.
  const Box& box() const { return box_; }

  /// Does the car's interior meet the wall on the way? Precondition: it does not at the beginning. `at` is where the
  /// leg begins this time, exactly; a leg between nodes of a lattice may begin elsewhere than the one this was made of.
  bool meets(const NearWall& wall, const Leg& at, const CarShape& shape) const;

  /// May the reference point get to the side of an opening that is solid? No only when it is certain that it does not:
  /// neither the ends nor the corner of the leg's tangents lie there, or the three keep away from it.
  bool may_leave(const Segment& opening, bool solid_left, const Leg& at) const;

 private:
  bool is_outside_ring(const NearWall& wall) const;

  Leg leg_;
  double length_ = 0;
  LegSweep<Approx> sweep_;
  Box box_{};
  Point pivot_{};
  double inner_ = 0, outer_ = 0;  // the ring that an arc's car keeps to, squared
};

}  // namespace taut::car::detail
