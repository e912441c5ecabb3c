// From one pose to (nearly) another by what this car can do: turn, straight, turn.
#pragma once

#include <vector>

#include <taut/robots/roadblocks/car.h>

namespace taut::roadblocks::detail {

/// A turn by `angle`, on an arc of the least radius or on the spot (three steps back, one of arc). Whole steps of
/// control 1 and one of less, which stands where the straight is: at the end, or, with `fraction_first`, at the
/// beginning. Back and arc shift the car sideways by 0.004, arc and back by as much to the other side: whole turns on
/// the spot come in such pairs, so that it stays where it is.
struct Turn {
  double angle = 0;
  bool on_the_spot = false;
  bool fraction_first = false;

  int steps() const;
  Point shift(double heading) const;  ///< how far it moves a car of that heading; in closed form
  void append_to(std::vector<double>& controls) const;
};

/// A way of three parts.
struct Steering {
  Turn first;
  int ahead = 0;  ///< steps straight ahead
  int back = 0;   ///< then straight back
  Turn last;
  double error = 0;  ///< how far from the wished position it ends

  int steps() const { return first.steps() + ahead + back + last.steps(); }
  std::vector<double> controls() const;
};

/// The ways from one pose to another, fewest steps first, walls unknown.
///
///  1. Turns are arcs to either side or on the spot, the straight goes ahead or back: at most 18 ways.
///  2. Heading: that of `to`, up to rounding and whole turns. It can be hit since a control's last fraction is free.
///  3. Position: at most kLanding off. No way lands exactly, because every step has a fixed length: straights come in
///     multiples of 0.05. Who goes on from `to` along known controls is off by the same vector all the way and has to
///     test it anew.
std::vector<Steering> steerings(const Pose& from, const Pose& to);

inline constexpr double kLanding = 0.05;

/// Where a step that ends at `to` began: the reverse of stepped(), up to rounding. Precondition: a control that moves.
Pose unstepped(const Pose& to, double control);

}  // namespace taut::roadblocks::detail
