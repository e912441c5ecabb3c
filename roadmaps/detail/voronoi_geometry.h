// The vertices and arcs of a segment Voronoi diagram, from the sites that define them. Private.
#pragma once

#include <array>
#include <functional>

#include <taut/geometry/point.h>
#include <taut/roadmaps/bezier.h>

namespace taut::detail {

/// A point equally far from three sites.
struct VoronoiPoint {
  Point at;
  double clearance = 0;  ///< the distance from the sites
  double error = 0;      ///< `at` is at most this far from the exact point; infinite when nothing is known
};

/// Refines `guess` to the point equally far from three sites; a site is a segment without its ends, or a point (a ==
/// b).
///  1. Newton's iteration in extended precision, `error` from Kantorovich's theorem ("Functional analysis and applied
///     mathematics", 1948) at its result plus the rounding to doubles: there is a point equally far from the sites
///     within `error`. Infinite when the theorem does not apply.
///  2. A segment and its own end are equally far on the perpendicular there, two segments that share an end on their
///     bisector: these are the equations used, so rounded walls, which bend by 1e-16, do no harm.
///  3. Two segments that bend at their shared end, with that end as third site: the end itself, clearance 0, no error.
///  4. Two segments that go straight on at their shared end, with that end: all points of the perpendicular; error
///     infinite.
VoronoiPoint voronoi_point(const std::array<Segment, 3>& sites, Point guess);
/// With a guess that is made only where one is needed: not where a piece and its own end are among the sites.
VoronoiPoint voronoi_point(const std::array<Segment, 3>& sites, const std::function<Point()>& guess);

/// The shared end when the sites are two segments and an end of both; else null. Guarantees 3 and 4.
const Segment* joint(const std::array<Segment, 3>& sites);
/// Do both share an end and lie on one line? Exact.
bool go_straight_on(const Segment& s, const Segment& t);
/// Is p a point and an end of the segment s?
bool is_own_end(const Segment& p, const Segment& s);
bool parallel(const Segment& s, const Segment& t);  ///< Exact.

/// The control point of the arc of the parabola with this focus and directrix between two points near it.
Point parabola_control(Point focus, const Segment& directrix, Point from, Point to);

}  // namespace taut::detail
