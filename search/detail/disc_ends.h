// What a disc meets at its ends, exactly. Private.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <optional>

#include <taut/geometry/free_space.h>
#include <taut/geometry/point.h>

namespace taut::detail {

/// |p - c|^2.
Rational squared_distance(Point p, const Segment& c);

/// The largest double r with r^2 <= squared.
double root_below(const Rational& squared);

/// The largest double that is not above the distance of p and c, taken as the doubles they are, when doubles are sure
/// of it.
std::optional<double> quick_distance_below(Point p, const Segment& c);

/// Do p and q, one of which may lie on a wall, touch one component of the free space?
bool share_component(const FreeSpace& space, Point p, Point q);

}  // namespace taut::detail
