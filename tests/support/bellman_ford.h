// Shortest paths in a graph by rounds over all legs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <taut/search/graph_search.h>

namespace taut::test {

inline Length plus_leg(Length length, Point p, Point q) {
  length.add(p, q);
  return length;
}

/// An independent road to the same answer: rounds over all legs until nothing gets shorter. Lengths of vertices, then
/// of goals.
inline std::vector<std::optional<Length>> bellman_ford(const Roadmap& map, const GraphQuery& query) {
  std::vector<std::optional<Length>> best(map.vertex_count() + query.goals.size());
  const auto offer = [&](std::size_t v, Length length) {
    if (best[v] && *best[v] <= length) return false;
    best[v] = std::move(length);
    return true;
  };
  for (const Roadmap::Vertex v : query.start.vertices) offer(v, plus_leg({}, query.start.point, map.point(v)));
  for (bool changed = true; changed;) {
    changed = false;
    for (Roadmap::Vertex u = 0; u < map.vertex_count(); ++u)
      for (const Roadmap::Vertex v : map.neighbours(u))
        if (best[u] && offer(v, plus_leg(*best[u], map.point(u), map.point(v)))) changed = true;
  }
  for (std::size_t i = 0; i < query.goals.size(); ++i) {
    for (const Roadmap::Vertex v : query.goals[i].vertices)
      if (best[v]) offer(map.vertex_count() + i, plus_leg(*best[v], map.point(v), query.goals[i].point));
    if (std::find(query.direct.begin(), query.direct.end(), i) != query.direct.end())
      offer(map.vertex_count() + i, plus_leg({}, query.start.point, query.goals[i].point));
  }
  return best;
}

}  // namespace taut::test
