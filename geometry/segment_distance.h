// Distances between segments: enclosed quickly, compared exactly.
#pragma once

#include <optional>

#include <taut/geometry/interval.h>
#include <taut/geometry/point.h>

namespace taut {

/// Encloses the distance of two closed segments; either may be a single point. A few ulp wide unless the foot is near
/// an end; [0, 0] exactly when they share a point; a single number when it is the difference of two coordinates and a
/// double.
Interval segment_distance_interval(const Segment& s, const Segment& t);

/// The sign of a - b; nothing when the enclosures cannot tell.
std::optional<int> compare(const Interval& a, const Interval& b);

/// The sign of dist(s1, t1) - dist(s2, t2). Exact (rationals, when the enclosures overlap).
int compare_segment_distances(const Segment& s1, const Segment& t1, const Segment& s2, const Segment& t2);

/// The distance of two closed segments, to the nearest double; 0 exactly when they share a point.
double segment_distance(const Segment& s, const Segment& t);

}  // namespace taut
