// The heuristics of graph searches.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <taut/search/detail/goal_distance.h>

namespace taut::detail {

/// What a heuristic but euclidean says of a point and a goal, off by less than 2^-50 of it.
inline double estimate_between(GraphHeuristic heuristic, Point p, Point goal) {
  const double dx = std::abs(p.x - goal.x), dy = std::abs(p.y - goal.y);
  const double more = std::max(dx, dy), less = std::min(dx, dy);
  switch (heuristic) {
    case GraphHeuristic::euclidean: return std::hypot(dx, dy);
    case GraphHeuristic::manhattan: return dx + dy;
    case GraphHeuristic::octile: return more - less + std::numbers::sqrt2 * less;
    case GraphHeuristic::chebyshev: return more;
    case GraphHeuristic::zero: return 0;
  }
  return 0;
}

/// At most what the heuristic says of p and the nearest goal of the query. O(goals).
inline double estimate_below(GraphHeuristic heuristic, const GraphQuery& query, Point p) {
  if (heuristic == GraphHeuristic::euclidean) return goal_distance_below(query, p);
  double least = query.goals.empty() ? 0 : HUGE_VAL;
  for (const Terminal& goal : query.goals) least = std::min(least, estimate_between(heuristic, p, goal.point));
  return least * (1 - 0x1p-49);
}

}  // namespace taut::detail
