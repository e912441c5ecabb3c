// Bug 1, Bug 2 and Tangent Bug: a point robot that knows where the goal is, and of the world only what it touches or
// sees.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/search/path.h>

namespace taut::bug {

/// Whose rules the robot keeps; guarantees 3 to 5 of travel().
enum class Algorithm {
  bug1,  ///< walks the whole contour it hits, returns the shorter way to its place nearest the goal, leaves there
  bug2,  ///< walks along the contour it hits until it is on the m-line again, no farther from the goal, and can go on
  tangent,  ///< goes around what it sees in its way by the corner that promises the shorter path
};

/// `bug1`, `bug2`, `tangent`
std::string_view name(Algorithm algorithm);

/// Which way the robot turns when it hits: left keeps the obstacle at its right hand. Tangent Bug: when both promise
/// the same.
enum class Turn { left, right };

/// Distances in the unit of the world.
struct Options {
  Algorithm algorithm = Algorithm::bug2;
  Turn turn = Turn::left;
  double range = std::numeric_limits<double>::infinity();  ///< how far Tangent Bug sees; 0: it only touches. >= 0
  bool record_views = false;                               ///< Tangent Bug: keep Journey::views
};

/// Where the robot hit or left a contour.
struct Contact {
  Point at;                    ///< to the nearest doubles that a robot can be at
  double distance = 0;         ///< from there to the goal, rounded
  std::uint32_t obstacle = 0;  ///< an index into Journey::obstacles
};

/// A contour that was in the robot's way: all that it touches when it keeps its hand on the wall, once around.
struct Obstacle {
  Interval perimeter;    ///< both sides of zero-thickness walls count
  std::size_t hits = 0;  ///< how often the robot hit it. Tangent Bug: how often it began to follow it
  /// Bug 2: how many places of it the m-line runs into, half its crossings when both ends are outside
  std::size_t entries = 0;
  std::size_t legs = 0;  ///< Tangent Bug: how often the robot went for a corner because this was in its way
};

/// What Tangent Bug saw from a place, for pictures: rounded, the circle of its range as chords of at most 4 degrees.
struct View {
  std::size_t point = 0;  ///< an index into path.points, where the robot was
  Ring ring;              ///< counter-clockwise
};

/// What came of it. Distances in the unit of the world.
struct Journey {
  bool reached = false;         ///< false: there is no path, proven
  Path path;                    ///< all that was walked; when not reached it ends where the proof was complete
  Interval bound;               ///< encloses the theoretical bound, see travel()
  double rounding = 0;          ///< what rounding can have added to the length at most
  std::vector<Contact> hits;    ///< H1, H2, ... Tangent Bug: where its straight way was seen to be blocked
  std::vector<Contact> leaves;  ///< L1, L2, ...; one less than hits when the goal was met on a contour, or never
  /// Tangent Bug: M1, M2, ... where it began to follow a contour; each ends at a leave point
  std::vector<Contact> minima;
  std::vector<Obstacle> obstacles;  ///< in the order of first hits
  std::vector<View> views;          ///< when recorded
};

/// The journey from `from` to `to`.
///
///  1. A contour is a closed walk along constrained sides with free space on one hand. The robot goes round free ends
///     of zero-thickness walls, and never slips through a joint. Openings of the world are walls. The goal is reached
///     when it is touched, from any side.
///  2. What is decided is decided exactly, on rational points: hits, nearest places, crossings of the m-line, whether
///     the way is free. Only the points of `path`, `hits` and `leaves` are rounded; the legs in between stay in the
///     triangles that the robot passes, so verify() accepts the path.
///  3. Bug 1. Length <= D + 1.5 * (sum of the perimeters hit), with D the distance of the ends. It leaves from a place
///     that is nearest the goal and from which the way to it begins in free space: all such places are tried, as both
///     sides of a wall tie. The next hit is strictly nearer than the whole contour, so each is hit at most once. When
///     no nearest place is open, none is: the contour separates the robot from the goal.
///  4. Bug 2. Length <= D + sum of entries * perimeter. It leaves at the first place of the contour that is on the
///     m-line between hit and goal (at the same point as the hit it may be too: the other side of a wall) and from
///     which the way leads off the contour. Each hit is strictly nearer than the last. The place of the contour that is
///     last on the m-line would do if the goal could be reached; so a whole turn without leaving proves that it cannot.
///  5. Tangent Bug. Rules, bound and proofs: docs/bug-algorithms.md. Length <= D + sum over contours of 1.5 * hits *
///     perimeter + what the legs to corners cost at most. It senses where it decides, not all along: at the start,
///     where an obstacle comes into range, at corners, and at places of a contour nearest the goal.
///  6. A start on an obstacle may have several sides or corners to stand in: they are tried in turn, those open to the
///     goal first, until one leads to the goal. The journey is that of the last one tried.
/// Throws InputError when an end is outside. O(n) set-up for n triangles, then O(contour) a hit; a view costs the
/// triangles seen. Source: Lumelsky, Stepanov, "Path-planning strategies for a point mobile automaton moving amidst
/// unknown obstacles of arbitrary shape" (1987); Kamon, Rimon, Rivlin, "TangentBug: a range-sensor-based navigation
/// algorithm" (1998).
Journey travel(const FreeSpace& space, Point from, Point to, const Options& options = {});

}  // namespace taut::bug
