// What a planner answers.
#pragma once

#include <vector>

#include <taut/geometry/length.h>
#include <taut/geometry/point.h>

namespace taut {

/// A polygonal path. One point when start is already the goal.
struct Path {
  std::vector<Point> points;
  Length length;
};

}  // namespace taut
