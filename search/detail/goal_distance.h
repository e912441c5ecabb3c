// The heuristic of graph searches.
#pragma once

#include <algorithm>
#include <cmath>

#include <taut/search/graph_search.h>

namespace taut::detail {

/// At most the distance from p to the nearest goal of the query. O(goals).
inline double goal_distance_below(const GraphQuery& query, Point p) {
  double least = 1e300;
  for (const Terminal& goal : query.goals) {
    const double dx = p.x - goal.point.x, dy = p.y - goal.point.y;
    least = std::min(least, dx * dx + dy * dy);
  }
  // The square is off by 4 roundings, unless it leaves the range of doubles.
  return least < 1e-290 || least >= 1e300 ? 0 : std::sqrt(least) * (1 - 0x1p-50);
}

}  // namespace taut::detail
