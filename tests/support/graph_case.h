// Small messy graphs for RapidCheck, and queries on them.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include <taut/search/graph_search.h>

namespace taut::test {

/// A roadmap and what is asked of it.
struct GraphCase {
  Roadmap map;
  GraphQuery query;
};

/// Few lattice points, many of them equal, so that nearly everything is tied.
inline GraphCase any_graph_case() {
  using Vertex = Roadmap::Vertex;
  using Edges = std::vector<std::pair<Vertex, Vertex>>;
  const auto n = *rc::gen::inRange<Vertex>(1, 14);
  const int range = *rc::gen::inRange(1, 6);
  const double unit = *rc::gen::element(1.0, 0.1, 0x1p-20);
  const auto point = [&] {
    const int x = *rc::gen::inRange(0, range), y = *rc::gen::inRange(0, range);
    return Point{x * unit, y * unit};
  };
  std::vector<Point> points;
  for (Vertex v = 0; v < n; ++v) points.push_back(point());
  const auto vertex = rc::gen::inRange<Vertex>(0, n);
  const auto edges =
      *rc::gen::container<Edges>(*rc::gen::inRange<std::size_t>(0, 3 * n), rc::gen::pair(vertex, vertex));
  const auto terminal = [&] {
    const Point p = point();
    return Terminal{p, *rc::gen::container<std::vector<Vertex>>(*rc::gen::inRange<std::size_t>(0, 4), vertex)};
  };
  GraphCase c{.map = Roadmap(points, edges), .query = {.start = terminal(), .goals = {}, .direct = {}}};
  const auto goals = *rc::gen::inRange<std::size_t>(0, 4);
  for (std::size_t i = 0; i < goals; ++i) {
    c.query.goals.push_back(terminal());
    if (*rc::gen::inRange(0, 8) == 0) c.query.direct.push_back(i);
  }
  return c;
}

}  // namespace taut::test
