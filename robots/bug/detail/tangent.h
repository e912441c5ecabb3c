// Tangent Bug among exact polygons: the rules, what they cost at most, and why they end.
#pragma once

#include <taut/robots/bug/bug.h>
#include <taut/robots/bug/detail/place.h>

namespace taut::bug::detail {

/// One journey from `stand`. The robot decides only where it stands, so its path is a chain of straight legs and pieces
/// of contours; in the paper it senses all along, and where its range ends its way is a curve.
///
/// d is the distance to the goal, R the range, p the perimeter of a contour. A *corner* is a vertex within R at which
/// the depth jumps.
///
///  Motion to the goal, from x, with a limit (d of all later corners is below it):
///   1. The robot goes straight to the goal until what blocks its way, at the place h of contour C, is within R. (Where
///      no pair of doubles is fit to stop at, it goes to h.)
///   2. Among the corners v with d(v) below the limit it goes straight to the one with the least |xv| + d(v). The ends
///      of the part of C in view around h take part: where one ends by the range, not by a corner, and is best, the
///      robot follows C that way.
///   3. Without any of them it follows C, towards the better end. At a tie (always so when R is 0) it prefers the side
///      of C that falls steeper towards the goal, then Options::turn.
///
///  Following C. `followed` is the least d of the part of C seen since h, in one piece:
///   4. What is in view of C ahead of that part counts as seen. The robot goes to its end, or to the corner that hides
///      the rest. When the range ends the view, or nothing new is in view, it goes along C to the end of the side.
///   5. It goes over to motion to the goal, with `followed` as the limit, when it can go straight to the goal to a
///      place with d below `followed` within R; or to a corner with d below `followed`; or to a vertex or foot of the
///      perpendicular from the goal on C with d = `followed` from which the way to the goal leads off C.
///   6. When all of C is seen the goal is out of reach.
///
///  Why 6: let m be a place of C nearest the goal. The robot leaves for m when the way from m leads off C (rule 5, m is
///  a vertex or a foot); when it does so at no nearest place, C separates the robot from the goal, as in Bug 1.
///
///  Why it ends: each time that it leaves C it does so for a corner or foot, or from one; d of it, or of where the way
///  from it is blocked, is at most `followed`, and each h is nearer than all before. So each of finitely many places
///  serves once. In between the limit falls from corner to corner, and a view of C grows by a side or up to one of
///  finitely many shadows.
///
///  Bound: length <= D + sum of what each act adds to the length beyond the fall of d. Straight on: 0. Following, from
///  x by h to y: at most 1.5 p, for it walks no more than |xh| + (the arc of C seen) - |y end of it|, and d(y) <= |y
///  end| + d(h) + the shorter arc. A leg to a corner v: |xv| + d(v) - d(x) <= 2 min(R, d(v)), and <= 2 p(C) when an end
///  of C in view was below the limit, as that one promises at most d(x) + 2 * (the arc from h to it). With R = 0 there
///  are no legs: D + 1.5 * sum of (times followed) * p.
Journey tangent_journey(const ContourPlaces& places, const Stand& stand, Point from, Point goal,
                        const Options& options);

}  // namespace taut::bug::detail
