// The best worst edge between any two nodes of a graph. Private.
#pragma once

#include <cstdint>
#include <vector>

namespace taut::detail {

/// Of all ways between two nodes, the one whose least edge is greatest. O(1) a question; n log n numbers.
class Bottleneck {
 public:
  struct Edge {
    std::uint32_t u, v;
    std::uint32_t rank;  ///< > 0
  };
  /// `edges`: the greatest rank first.
  Bottleneck(std::uint32_t nodes, const std::vector<Edge>& edges);

  /// The least rank on the best way; 0 where there is none, kNone from a node to itself.
  std::uint32_t between(std::uint32_t u, std::uint32_t v) const;

 private:
  std::vector<std::uint32_t> position_;
  /// [k]: the least of 2^k ranks between neighbours in line.
  std::vector<std::vector<std::uint32_t>> least_;
};

}  // namespace taut::detail
