// Anybody's path, audited: can it be followed, where not, how near it comes to walls, how long it is, what is shorter.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/geometry/interval.h>
#include <taut/geometry/length.h>
#include <taut/geometry/nearest_free.h>

namespace taut {

/// Where a robot on its path first meets what it must not.
struct PathContact {
  std::size_t leg = 0;  ///< from 0
  Point at;             ///< the robot's reference point then, to rounding
  Point on;             ///< the point of the obstacle that it meets, to rounding
  NearObstacle wall;    ///< that obstacle, as the world has it
};

/// What there is to say of a path.
struct PathAudit {
  bool valid = false;
  std::string reason{};                   ///< empty when valid, else one line
  std::optional<PathContact> contact{};   ///< when a wall is why it is not
  double clearance = 0;                   ///< least distance between robot and walls; infinite where there are none
  std::optional<NearObstacle> nearest{};  ///< when valid: where that is
  Length length{};                        ///< exact
};

/// What no path is shorter than.
struct ShortestLength {
  double value = 0;    ///< of a point or a polygon the double nearest to it
  Interval enclosure;  ///< of the exact length
};

/// Audits paths in one world.
///
///  1. A point or a polygon may touch obstacles, as verify() says; a disc is the disc itself, not a polygon around it,
///     and its centre may come as near to a wall as its radius, exactly. Walls and openings are those of Gates,
///     guarantee 1: a disc may stick out of an opening of the world.
///  2. Whether a path is valid and which leg is the first that is not are exact; of several walls in the way of that
///     leg the first is found by doubles.
///  3. The clearance is to the nearest double; of a disc it is that of its centre less the radius; of a polygon that
///     of its reference point in its own free space. Openings are no walls.
/// Where crossings of walls were rounded (space().report().displacement), answers are those of the rounded walls.
class PathAuditor {
 public:
  /// `places`: points of the paths, which a wall that they lie on as written must not bend away from.
  PathAuditor(const World& world, const Footprint& robot, std::span<const Point> places = {});

  /// Between its own ends. O((n + k) log k) for k legs; of a disc O(k log n) more.
  PathAudit audit(const std::vector<Point>& points) const;

  /// The same without clearance and what is nearest. Of a disc that is away from openings O(k log n).
  PathAudit check(const std::vector<Point>& points) const;

  /// The length of the shortest path between two places. Nothing when there is none, or an end is no place. Of a disc a
  /// TangentGraph is built first.
  std::optional<ShortestLength> shortest(Point from, Point to) const;

  /// Of a point's free space where the robot is a disc.
  const FreeSpace& space() const;

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace taut
