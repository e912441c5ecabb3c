// A general car and the pieces its drives are made of: exact, for ever.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/robots/car/heading.h>
#include <taut/robots/car/pose.h>

namespace taut::car {

/// A rectangular car. Its reference point is the middle of the rear axle: the point that moves along the heading.
/// Lengths in the world's unit.
struct CarShape {
  double front = 0;       ///< from the reference point to the front, >= 0
  double back = 0;        ///< to the rear end, >= 0; front + back > 0
  double half_width = 0;  ///< > 0
  double radius = 0;      ///< the least turning radius of the reference point, > 0
  bool reverse = true;    ///< may it go back?

  /// The largest disc around the reference point that is inside the car.
  double inner_radius() const;
  /// The largest distance of a point of the car from the reference point, rounded up.
  double outer_radius() const;
};

/// A car of this length and width whose rear axle lies `rear` before its rear end. Where length - rear is no double it
/// is rounded up. Throws InputError unless all are finite, of magnitude 1e-9 to 1e9, and 0 <= rear <= length (rear may
/// be 0).
CarShape car_shape(double length, double width, double radius, double rear, bool reverse = true);

/// Where the reference point is, exactly, and where the car looks: one of the kHeadings.
struct LatticePose {
  Point at;
  int heading = 0;
  friend bool operator==(const LatticePose&, const LatticePose&) = default;
};

/// A piece of a drive. With the same headings it is straight; otherwise the reference point goes straight along the one
/// heading, then on the arc that touches both lines, then straight along the other, and one of the two straight pieces
/// has length 0. Poses at both ends decide all that: nothing is rounded, and the end of one leg is the beginning of the
/// next, however long the drive.
struct Leg {
  LatticePose from;
  LatticePose to;
  bool backward = false;
  friend bool operator==(const Leg&, const Leg&) = default;
};

/// What a leg looks like, to rounding.
struct LegCurve {
  double before = 0;  ///< length of the straight piece at its beginning
  double radius = 0;  ///< of the arc; 0: there is none
  double turn = 0;    ///< change of heading, radians, positive counter-clockwise
  double after = 0;   ///< length of the straight piece at its end
  double length() const;
};

/// Why the car cannot drive such a leg, in words; nothing when it can. Exact:
///  1. the headings differ by less than 180 degrees, and by 0 only if the leg is straight along them;
///  2. both tangents point the way it goes, so both straight pieces have a length >= 0;
///  3. the arc's radius, a rational number, is at least shape.radius;
///  4. `backward` only where shape.reverse.
std::optional<std::string> validate(const Leg& leg, const CarShape& shape);

/// How often the car changes between forward and back.
std::size_t reversals_of(const std::vector<Leg>& legs);

/// Precondition: the leg has no fault but 3 or 4.
LegCurve curve_of(const Leg& leg);

/// The pose after the part `along` in [0, 1] of its length, to rounding; the ends are exact but for the heading's
/// radians.
Pose pose_on(const Leg& leg, double along);

}  // namespace taut::car
