// A search tree over what may be known of doors, for comparison with rollouts.
#pragma once

#include <vector>

#include <taut/robots/roadblocks/detail/door_values.h>

namespace taut::roadblocks::detail {

/// UCT (Kocsis, Szepesvari 2006) as Eyerich, Keller, Helmert 2010 have it for the Canadian traveller: a node is a place
/// and a belief, its actions are the sights of unknown doors that can be reached and the goal; each of kUctRuns drives
/// in one of the worlds follows the tree by least mean less what is owed to what was seldom tried, and ends, where the
/// tree does, with the optimist's rollout. The action most often taken, and its mean; the goal where there is no other.
/// `hoped`: the door that the optimist's plan crosses first. Precondition: a sight or the goal can be reached.
Option uct_option(DoorGraph& graph, const std::vector<double>& legs, const Belief& belief, DoorSet hoped,
                  const std::vector<World>& worlds);

inline constexpr std::size_t kUctRuns = 1000;

}  // namespace taut::roadblocks::detail
