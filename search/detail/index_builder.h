// An index built so that it fits into a memory budget.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <taut/roadmaps/visibility_graph.h>

namespace taut::detail {

/// The bytes of an index (IndexImage), at most `memory` of them; nothing where that is too little. All bends have
/// labels where those fit, with sights where these fit as well; else the others are contracted below a core as large
/// as seems to, or of `core_size`. Precondition: the graph is a reduced one.
std::optional<std::vector<std::byte>> index_bytes(const VisibilityGraph& graph, std::size_t memory,
                                                  std::optional<std::size_t> core_size = std::nullopt,
                                                  const TellProgress& tell = {});

}  // namespace taut::detail
