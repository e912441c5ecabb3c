// A drive checked by code that shares nothing with the planner but the legs.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include <taut/geometry/free_space.h>
#include <taut/robots/car/leg.h>

namespace taut::car {

/// What was found wrong first.
struct DriveFault {
  std::size_t leg = 0;               ///< its index
  std::string text;                  ///< in words: `meets the wall (1, 0)-(1, 2)`
  std::uint32_t constraint = kNone;  ///< of the space
};

/// Does the car get along these legs without harm? Nothing when it does. Exact:
///  1. each leg is one the car can drive (validate), and begins with the pose that the one before ends with;
///  2. both ends of each leg are places for the reference point (FreeSpace::locate), and it crosses no opening of the
///     world;
///  3. the interior of the car meets no wall (constraint of the space that is no opening) at any time. Touching is
///     allowed.
///
/// Method: on each piece of a leg the car's sides and corners are, up to a positive factor, polynomials of degree 2 at
/// most in the distance (straight) or in the tangent of half the turn (arc), with rational coefficients. Car and wall
/// are apart when one of six lines separates them, that is when certain of these are >= 0. The times of contact are
/// open, so they begin at 0 or right after a root of one of them, and there every sign is decided in the field of that
/// root. Walls are looked at one after the other: O(legs * walls) boxes. `space` is the free space of a point robot.
std::optional<DriveFault> verify_drive(std::span<const Leg> legs, const FreeSpace& space, const CarShape& shape);

/// Does the car's interior meet the wall anywhere on the leg, ends included? By the method above. Precondition: the leg
/// has no fault but its radius.
bool drive_meets(const Leg& leg, const CarShape& shape, const Segment& wall);

/// Does the interior of the car that stands there meet the wall?
bool stand_meets(const LatticePose& pose, const CarShape& shape, const Segment& wall);

}  // namespace taut::car
