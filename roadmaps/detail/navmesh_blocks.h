// Biconnected components of a navigation mesh.
#pragma once

#include <taut/roadmaps/navmesh.h>

namespace taut::detail {

/// Fills in `block` of every portal and `blocks`. Depth-first search without recursion (Hopcroft, Tarjan 1973).
/// O(portals).
void find_blocks(Navmesh& mesh);

}  // namespace taut::detail
