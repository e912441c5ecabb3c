// Exact search against Boost.Graph with double weights stored beside the edges, on an 8-connected lattice, where nearly
// every length is tied. The peer's answer is checked against the exact one to rounding.
#include <benchmark/benchmark.h>

#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <cmath>
#include <cstdlib>
#include <vector>

#include <taut/search/graph_search.h>

namespace {

using taut::Point;
using taut::Roadmap;
using Vertex = Roadmap::Vertex;

/// n x n points one unit apart, joined to their 8 neighbours; every seventh point of every other row is missing.
Roadmap lattice(Vertex n) {
  std::vector<Point> points;
  std::vector<std::pair<Vertex, Vertex>> edges;
  const auto is_there = [](Vertex x, Vertex y) { return y % 2 == 0 || x % 7 != 3; };
  for (Vertex y = 0; y < n; ++y)
    for (Vertex x = 0; x < n; ++x) {
      points.push_back({static_cast<double>(x), static_cast<double>(y)});
      if (!is_there(x, y)) continue;
      const Vertex v = y * n + x;
      const auto join = [&](bool inside, Vertex w) {
        if (inside && is_there(w % n, w / n)) edges.emplace_back(v, w);
      };
      join(x + 1 < n, v + 1);
      join(y + 1 < n, v + n);
      join(x + 1 < n && y + 1 < n, v + n + 1);
      join(x > 0 && y + 1 < n, v + n - 1);
    }
  return Roadmap(std::move(points), edges);
}

constexpr Vertex kSide = 300;
const Roadmap& map() {
  static const Roadmap roadmap = lattice(kSide);
  return roadmap;
}
constexpr Vertex kFrom = 2 * kSide + 2, kTo = 190 * kSide + 290;

taut::GraphQuery query() {
  return {.start = {map().point(kFrom), {kFrom}}, .goals = {{map().point(kTo), {kTo}}}, .direct = {}};
}

void exact(benchmark::State& state, taut::GraphAlgorithm algorithm) {
  taut::GraphSearchResult result;
  for (auto _ : state) result = graph_search(map(), query(), algorithm);
  state.counters["expanded"] = static_cast<double>(result.expanded);
  state.counters["length"] = result.path.length.value();
}

using Csr = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property,
                                               boost::property<boost::edge_weight_t, double>, boost::no_property,
                                               Vertex, std::uint32_t>;

const Csr& csr() {
  static const Csr graph = [] {
    std::vector<std::pair<Vertex, Vertex>> edges;
    std::vector<double> weights;
    for (Vertex v = 0; v < map().vertex_count(); ++v)
      for (const Vertex w : map().neighbours(v)) {
        edges.emplace_back(v, w);
        weights.push_back(std::hypot(map().point(v).x - map().point(w).x, map().point(v).y - map().point(w).y));
      }
    return Csr(boost::edges_are_sorted, edges.begin(), edges.end(), weights.begin(),
               static_cast<Vertex>(map().vertex_count()));
  }();
  return graph;
}

struct Found {};
struct DoubleHeuristic {
  double operator()(Vertex v) const {
    return std::sqrt((map().point(v).x - map().point(kTo).x) * (map().point(v).x - map().point(kTo).x) +
                     (map().point(v).y - map().point(kTo).y) * (map().point(v).y - map().point(kTo).y));
  }
};
template <class Base>
struct StopAtGoal : Base {
  std::size_t* expanded;
  explicit StopAtGoal(std::size_t* count) : expanded(count) {}
  void examine_vertex(Vertex v, const Csr&) const {
    if (v == kTo) throw Found{};
    ++*expanded;
  }
};

void peer(benchmark::State& state, taut::GraphAlgorithm algorithm) {
  const auto index = get(boost::vertex_index, csr());
  std::size_t expanded = 0;
  double length = 0;
  for (auto _ : state) {
    expanded = 0;
    std::vector<Vertex> predecessor(map().vertex_count());
    std::vector<double> distance(map().vertex_count());
    const auto predecessors = boost::make_iterator_property_map(predecessor.begin(), index);
    const auto distances = boost::make_iterator_property_map(distance.begin(), index);
    try {
      if (algorithm == taut::GraphAlgorithm::astar)
        boost::astar_search(csr(), kFrom, DoubleHeuristic{},
                            boost::visitor(StopAtGoal<boost::default_astar_visitor>(&expanded))
                                .predecessor_map(predecessors)
                                .distance_map(distances));
      else
        boost::dijkstra_shortest_paths(csr(), kFrom,
                                       boost::visitor(StopAtGoal<boost::default_dijkstra_visitor>(&expanded))
                                           .predecessor_map(predecessors)
                                           .distance_map(distances));
    } catch (Found) {
    }
    length = distance[kTo];
  }
  if (std::abs(length - graph_search(map(), query()).path.length.value()) > 1e-9) std::abort();
  state.counters["expanded"] = static_cast<double>(expanded);
}

void all_targets(benchmark::State& state) {
  const std::shared_ptr<const Roadmap> shared(&map(), [](const Roadmap*) {});
  for (auto _ : state) benchmark::DoNotOptimize(taut::GraphShortestPaths(shared, {map().point(kFrom), {kFrom}}));
}

BENCHMARK_CAPTURE(exact, astar, taut::GraphAlgorithm::astar)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(peer, astar, taut::GraphAlgorithm::astar)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exact, dijkstra, taut::GraphAlgorithm::dijkstra)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(peer, dijkstra, taut::GraphAlgorithm::dijkstra)->Unit(benchmark::kMillisecond);
BENCHMARK(all_targets)->Unit(benchmark::kMillisecond);

}  // namespace
