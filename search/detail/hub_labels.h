// Which hubs each vertex keeps its distance from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <taut/geometry/progress.h>
#include <taut/search/detail/hub_tree.h>

namespace taut::detail {

/// For any two vertices that a shortest path passes, one after the other: some vertex between them, or one of them, is
/// a hub of both. So their distance is the least sum over common hubs.
struct HubLabels {
  struct Label {
    std::uint32_t hub;   ///< its number in `vertices`
    std::uint32_t edge;  ///< the first on the way to it; kNone of the vertex itself
    double length;
  };
  /// The other half of its length.
  struct Rest {
    double low;
    std::uint64_t print;
  };

  std::vector<std::uint32_t> vertices;     ///< the hubs, those on most shortest paths first
  std::vector<std::uint32_t> hub_of;       ///< the other way round
  std::vector<std::vector<Label>> labels;  ///< by vertex, hubs ascending
  std::vector<std::vector<Rest>> rests;

  std::size_t count() const;
};

/// The vertices in an order in which few labels are needed: always that one which lies on most of the shortest paths,
/// of `samples` trees, that no vertex before it lies on. (Delling, Goldberg, Pajor, Werneck, "Robust distance queries
/// on massive networks", 2014.)
std::vector<std::uint32_t> hub_order(const HubGraph& graph, HubTree& tree, std::size_t samples);

/// Pruned landmark labels (Akiba, Iwata, Yoshida, "Fast exact shortest-path distance queries on large networks by
/// pruned landmark labeling", 2013), without those that no shortest path needs. Nothing where there would be more than
/// `most`. Told are the hubs.
std::optional<HubLabels> hub_labels(const HubGraph& graph, HubTree& tree, const SightLists* sights,
                                    std::vector<std::uint32_t> order, std::size_t most, const TellProgress& tell = {});

}  // namespace taut::detail
