// A roadmap full of ties.
#pragma once

#include <utility>
#include <vector>

#include <taut/roadmaps/roadmap.h>

namespace taut::test {

/// n x n vertices at whole coordinates, by rows, each joined to its eight neighbours.
inline Roadmap lattice(Roadmap::Vertex n) {
  std::vector<Point> points;
  std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>> edges;
  for (Roadmap::Vertex y = 0; y < n; ++y)
    for (Roadmap::Vertex x = 0; x < n; ++x) {
      const Roadmap::Vertex v = y * n + x;
      points.push_back({static_cast<double>(x), static_cast<double>(y)});
      if (x + 1 < n) edges.emplace_back(v, v + 1);
      if (y + 1 < n) edges.emplace_back(v, v + n);
      if (x + 1 < n && y + 1 < n) edges.emplace_back(v, v + n + 1);
      if (x > 0 && y + 1 < n) edges.emplace_back(v, v + n - 1);
    }
  return Roadmap(std::move(points), edges);
}

}  // namespace taut::test
