// Ways of a mouse through what is surely open, and what shows on them. Private.
#pragma once

#include <cstddef>
#include <vector>

#include <taut/robots/micromouse/detail/belief.h>

namespace taut::micromouse::detail {

/// From a pose to all others that it can reach: the fewest steps, of these the way that shows most. Nodes are
/// index_of(cell) * 4 + heading.
struct LookWays {
  std::vector<int> steps;          ///< -1: not reached
  std::vector<float> collected;    ///< weight of the look at the end, and `side_looks` times that of the way before
  std::vector<Action> by;          ///< the last action
  std::vector<std::size_t> from;   ///< before it
  std::vector<std::size_t> order;  ///< nodes reached, nearest first; the first one is the pose itself

  /// The last action first.
  std::vector<Action> way_to(std::size_t node) const;
};

std::size_t node_of(const WallMap& map, const MousePose& pose);

LookWays look_ways(const WallMap& map, std::size_t root, const Outlook& outlook, double side_looks);

}  // namespace taut::micromouse::detail
