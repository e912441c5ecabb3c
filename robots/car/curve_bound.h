// Lower bounds for the search. Private.
#pragma once

#include <taut/robots/car/pose.h>

namespace taut::car::detail {

/// Arcs that close to a full turn count as none: more than rounding can make of a square root that should be 0.
inline constexpr double kBoundSnap = 1e-6;

/// No longer than the shortest path without walls, rounding included: within 4e-6 radii of it where no arc is that
/// close to a full turn.
double dubins_bound(const Pose& from, const Pose& to, double radius);
double reeds_shepp_bound(const Pose& from, const Pose& to, double radius);

}  // namespace taut::car::detail
