#include <taut/search/detail/bottleneck.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

#include <taut/geometry/triangulation.h>

namespace taut::detail {

Bottleneck::Bottleneck(std::uint32_t nodes, const std::vector<Edge>& edges) : position_(nodes) {
  // Kruskal. What is joined stands in one line, and the edge that joins two lines stands between them: the least edge
  // between any two is the bottleneck.
  std::vector<std::uint32_t> parent(nodes), last(nodes), next(nodes, kNone), rank(nodes, 0);
  std::iota(parent.begin(), parent.end(), 0u);
  last = parent;
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Edge& e : edges) {
    const std::uint32_t u = root(e.u), v = root(e.v);
    if (u == v) continue;
    next[last[u]] = v;
    rank[last[u]] = e.rank;
    last[u] = last[v];
    parent[v] = u;
  }
  std::vector<std::uint32_t> line;
  for (std::uint32_t v = 0; v < nodes; ++v)
    if (parent[v] == v)
      for (std::uint32_t at = v; at != kNone; at = next[at]) {
        position_[at] = static_cast<std::uint32_t>(line.size());
        line.push_back(rank[at]);
      }
  least_.push_back(std::move(line));
  for (std::size_t width = 1; 2 * width <= nodes; width *= 2) {
    const auto& half = least_.back();
    std::vector<std::uint32_t> whole(nodes - 2 * width + 1);
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] = std::min(half[i], half[i + width]);
    least_.push_back(std::move(whole));
  }
}

std::uint32_t Bottleneck::between(std::uint32_t u, std::uint32_t v) const {
  if (u == v) return kNone;
  const auto [first, last] = std::minmax(position_[u], position_[v]);
  const int k = std::bit_width(last - first) - 1;
  return std::min(least_[k][first], least_[k][last - (1u << k)]);
}

}  // namespace taut::detail
