// Boost.Graph's Dijkstra beside a loop of one's own with std::priority_queue, on the two graphs where taut had one: the
// diagram with the ends of a query, and a visibility graph from a goal. Answers are compared to the bit.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include <taut/geometry/triangulation.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/roadmaps/voronoi.h>
#include <taut/search/detail/clearance_net.h>
#include <taut/search/roadmap_distances.h>

#include "mazes.h"

namespace {

using namespace taut;

/// Lengths from `sources`. each(v, visit) calls visit(w, length, how) for the ways on from v, and last[w] becomes the
/// `how` of the best one.
template <class Each>
std::vector<double> lengths_by_a_loop(std::size_t n, const std::vector<RoadmapSource>& sources, Each each) {
  using Open = std::pair<double, std::uint32_t>;
  std::vector<double> length(n, HUGE_VAL);
  std::vector<std::uint32_t> last(n, kNone);
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const auto reach = [&](std::uint32_t v, double l, std::uint32_t how) {
    if (l >= length[v]) return;
    length[v] = l;
    last[v] = how;
    open.push({l, v});
  };
  for (const auto& [v, l] : sources) reach(v, l, kNone);
  while (!open.empty()) {
    const auto [l, v] = open.top();
    open.pop();
    if (l > length[v]) continue;
    each(v, [&, from = l](std::uint32_t w, double leg, std::uint32_t how) { reach(w, from + leg, how); });
  }
  benchmark::DoNotOptimize(last.data());
  return length;
}

/// The diagram's edges alone; the goal is in a node of its own, so that all of it is searched.
detail::ClearanceNet net_of(const VoronoiRoadmap& map) {
  detail::ClearanceNet net;
  net.nodes = static_cast<std::uint32_t>(map.vertices().size()) + 1;
  for (std::uint32_t i = 0; i < map.edges().size(); ++i) {
    const VoronoiEdge& e = map.edges()[i];
    net.arcs.push_back({e.from, e.to, i, e.rank, e.length, map.curve(e)});
  }
  net.index();
  return net;
}

std::vector<double> net_by_a_loop(const detail::ClearanceNet& net, std::uint32_t rank) {
  return lengths_by_a_loop(net.nodes, {{0, 0}}, [&](std::uint32_t v, auto visit) {
    for (std::uint32_t i = net.offsets[v]; i < net.offsets[v + 1]; ++i) {
      const detail::Arc& a = net.arcs[net.arcs_at[i]];
      if (a.rank >= rank) visit(a.from == v ? a.to : a.from, a.length, net.arcs_at[i]);
    }
  });
}

void diagram(benchmark::State& state, bool boost) {
  const VoronoiRoadmap map(FreeSpace(bench::opened_maze(int(state.range(0)), 0.5)));
  const detail::ClearanceNet net = net_of(map);
  const auto rank = static_cast<std::uint32_t>(state.range(1));
  const auto by_boost = [&] { return shortest_ways(detail::WideArcs(net, rank), 0, net.nodes - 1).length; };
  if (by_boost() != net_by_a_loop(net, rank)) state.SkipWithError("they differ");
  for (auto _ : state) benchmark::DoNotOptimize(boost ? by_boost() : net_by_a_loop(net, rank));
}

void field(benchmark::State& state, bool boost) {
  const double far = double(state.range(0)) - 0.5;
  const VisibilityGraph graph(FreeSpace(bench::opened_maze(int(state.range(0)), 0.5).with_wall_thickness(0.1)));
  const Roadmap& map = graph.roadmap();
  const auto leg = [&](Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); };
  std::vector<RoadmapSource> sources;
  for (const Roadmap::Vertex v : graph.visible_from({far, far})) sources.push_back({v, leg(map.point(v), {far, far})});
  const auto by_boost = [&] { return roadmap_distances(map, sources).length; };
  const auto by_a_loop = [&] {
    return lengths_by_a_loop(map.vertex_count(), sources, [&](std::uint32_t v, auto visit) {
      for (const Roadmap::Vertex w : map.neighbours(v)) visit(w, leg(map.point(v), map.point(w)), v);
    });
  };
  if (by_boost() != by_a_loop()) state.SkipWithError("they differ");
  for (auto _ : state) benchmark::DoNotOptimize(boost ? by_boost() : by_a_loop());
}

#define TAUT_SIZES ->Args({30, 0})->Args({100, 0})->Unit(benchmark::kMillisecond)
BENCHMARK_CAPTURE(diagram, boost, true) TAUT_SIZES;
BENCHMARK_CAPTURE(diagram, own_loop, false) TAUT_SIZES;
BENCHMARK_CAPTURE(field, boost, true) TAUT_SIZES;
BENCHMARK_CAPTURE(field, own_loop, false) TAUT_SIZES;

}  // namespace
