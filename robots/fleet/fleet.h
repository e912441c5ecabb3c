// Many robots with times: do any two of them collide?
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <taut/geometry/point.h>

namespace taut::fleet {

struct TimedPoint {
  double time = 0;
  Point at;
};

/// A disc that moves straight and evenly from each place to the next.
struct Robot {
  std::string id;
  double radius = 0;               ///< > 0
  std::vector<TimedPoint> points;  ///< not empty; times ascend strictly
};

/// Where a robot is before its first and after its last time.
enum class Ends {
  stay,    ///< it stands where it begins and ends
  vanish,  ///< nowhere
};

/// Two robots that are nearer than the sum of their radii, for a time.
struct Collision {
  std::size_t first = 0, second = 0;          ///< robots, by number, first < second
  std::size_t first_leg = 0, second_leg = 0;  ///< when it begins: the legs after these points (or waits there)
  double from = 0, to = 0;                    ///< when the discs begin and cease to overlap, to rounding
  Point first_at, second_at;                  ///< their centres then, to rounding
};

/// All collisions, by the time that they begin, then by numbers.
///
///  1. Discs may touch: a collision is a time at which the distance of the centres is less than the sum of the radii.
///     That there is one is decided exactly for what times, places and radii mean (written.h): by doubles with a bound
///     of their error, else in rationals. Relative to one of two robots the other one moves straight, so it is the
///     distance of a point and a segment.
///  2. `from` and `to` are roots of a quadratic, to rounding; a collision that goes on from leg to leg is one.
/// Method: time is cut into about as many slabs as a robot has legs; in each the boxes of what moves there are swept
/// along x. O(n log n) for n legs spread evenly over time and space.
std::vector<Collision> collisions(std::span<const Robot> robots, Ends ends = Ends::stay);

}  // namespace taut::fleet
