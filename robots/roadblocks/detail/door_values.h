// What going to see a door is worth: simulated drives between doors in random worlds.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include <taut/robots/roadblocks/detail/door_graph.h>
#include <taut/robots/roadblocks/roadblock_policy.h>

namespace taut::roadblocks::detail {

struct Belief {
  DoorSet open = 0, closed = 0;

  bool is_known(DoorSet door) const { return ((open | closed) & door) != 0; }
  Belief after(DoorSet door, DoorSet world) const {
    return world & door ? Belief{open | door, closed} : Belief{open, closed | door};
  }
};

struct World {
  RoadblockSet blocks = 0;  ///< open
  DoorSet doors = 0;        ///< open
};

/// What to make for: the sight of an unknown door, or the goal.
struct Option {
  int node = 0;
  double value = std::numeric_limits<double>::infinity();
  double price = 0;  ///< by which the drive goes on if the door is open
  bool is_optimists = false;
};

/// The drive goes from sight to sight by the best way that takes unknown doors for open at this price
/// (DoorGraph::Ways), to the goal. Steps from `node`; where the places know no way out, more than any drive.
double rollout(DoorGraph& graph, int node, Belief belief, double price, const World& world);

/// Values options by rollouts.
class DoorValues {
 public:
  DoorValues(DoorGraph& graph, Aim aim) : graph_(graph), aim_(aim) {}

  /// Of the drives on from a sight: the mean (Aim::worst: maximum) over the worlds, of the best price for each state
  /// that the door may show.
  Option of(int sight, const Belief& belief, const std::vector<World>& worlds);

 private:
  double together(int sight, const Belief& then, double price, const std::vector<World>& worlds, DoorSet door,
                  DoorSet state);

  DoorGraph& graph_;
  Aim aim_;
};

}  // namespace taut::roadblocks::detail
