// What planners answer, as Python sees it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/python/bind.h>
#include <taut/search/path.h>

namespace taut::python {

/// A path, and what it is a path of.
struct FoundPath {
  FreeSpace space;
  Point from;
  Goal to;
  Path path;
  bool optimal = true;  ///< the shortest, proven; with `within` as far as that goes
  double within = 0;    ///< rounding_bound; 0 for a disc, whose claim is about its polygon
  std::string planner = {};
  std::size_t expanded = 0;
};

/// Of a proven `none`: why.
struct Apart {
  FreeSpace space;
  Point from;
  Goal to;
  std::vector<Segment> walls;  ///< that separate, in order; none where no place of the goal is free
};

/// The ends of a query: those given, or the world's. Throws Refusal where there is neither.
Point start_of(const World& world, const std::optional<Point>& given);
Goal goal_of_query(const World& world, const Goal& given);
/// Throws Refusal when an end is no place for the robot.
void require_ends(const FreeSpace& space, Point from, const Goal& to);

/// Length::decimals; ValueError for places that are none.
std::string decimals_of(const Length& length, int places);

/// That there is no path, proven; nothing when that is not. Without Python's lock.
std::optional<Apart> apart(const FreeSpace& space, Point from, const Goal& to);
/// What Unproven says.
std::string unproven_text(const FreeSpace& space);
/// `within` of a FoundPath.
double within_of(const FreeSpace& space);

}  // namespace taut::python
