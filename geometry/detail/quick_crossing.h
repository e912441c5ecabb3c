// Where two segments cross, rounded to doubles, when 106 bits can tell.
#pragma once

#include <optional>

#include <taut/geometry/point.h>

namespace taut::detail {

/// The rounding of a crossing that is no pair of doubles.
struct RoundedCrossing {
  Point point;              ///< each coordinate the double nearest to the exact one
  double displacement = 0;  ///< at least the distance to the exact point
};

/// Where s and t, which cross properly, meet; in double-double arithmetic with a proven error bound. Nothing when the
/// bound does not separate the exact coordinates from a double or from the middle between two (then line_crossing
/// decides). About fifty times faster than rationals.
std::optional<RoundedCrossing> quick_crossing(const Segment& s, const Segment& t);

}  // namespace taut::detail
