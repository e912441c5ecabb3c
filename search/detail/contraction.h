// Bends taken out of a graph, one after the other, until few are left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <taut/search/detail/bend_turns.h>
#include <taut/search/detail/hub_graph.h>

namespace taut::detail {

/// A contraction hierarchy (Geisberger, Sanders, Schultes, Delling, "Contraction hierarchies", 2008) that ends early:
/// shortest paths go up from both ends, to bends taken out later or never, and among these, the core, along its edges.
/// Between two neighbours of a bend that is taken out an edge takes its place, where a string turns there and no other
/// way is as short.
struct Contraction {
  struct Edge {
    std::uint32_t to = kNone;
    std::uint32_t first_hop = kNone;  ///< the bend after this end, and the one before `to`
    std::uint32_t last_hop = kNone;
    std::uint32_t middle = kNone;   ///< the bend that it passes; kNone of a leg
    std::uint32_t first_child = 0;  ///< the middle's up-edges back to this end, and on to `to`
    std::uint32_t last_child = 0;
    std::uint32_t arriving = 0;  ///< TurnBits of a string that comes along it the other way, at this end
    PrintedLength length;
  };

  std::vector<std::vector<Edge>> up;  ///< by bend: to those taken out later; of the core, to one another
  std::vector<std::uint32_t> core;    ///< ascending

  /// Appends the legs of an edge of bend `from`.
  void legs(std::uint32_t from, const Edge& edge, const BendTurns& turns, std::vector<Segment>& out) const;
};

/// `core_size` bends are left. Deterministic.
Contraction contraction(const HubGraph& graph, const BendTurns& turns, std::size_t core_size);

/// Core and edges as a graph to be labelled, the vertices being contraction.core in order. All outlive it. `edge_of`:
/// for each of its edges that one of contraction.up[core].
HubGraph core_graph(const Contraction& contraction, const BendTurns& turns, std::vector<std::uint32_t>& edge_of);

}  // namespace taut::detail
