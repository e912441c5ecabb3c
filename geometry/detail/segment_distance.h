// Distances between segments: enclosed quickly, compared exactly. Private.
#pragma once

#include <taut/geometry/length.h>
#include <taut/geometry/point.h>

namespace taut::detail {

/// Encloses the distance of two closed segments; either may be a single point. A few ulp wide unless the foot is near an end; [0, 0] exactly when
/// they share a point.
Interval segment_distance_interval(const Segment& s, const Segment& t);

/// The sign of dist(s1, t1) - dist(s2, t2). Exact (rationals, when the enclosures overlap).
int compare_segment_distances(const Segment& s1, const Segment& t1, const Segment& s2, const Segment& t2);

/// The distance of two closed segments, to the nearest double; 0 exactly when they share a point.
double segment_distance(const Segment& s, const Segment& t);

}  // namespace taut::detail
