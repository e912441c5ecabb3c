// The shortest path of a disc of radius 0.3 through mazes by size: true arcs. Peer: the space inflated by the
// circumscribed 64-gon and its reduced visibility graph, space included, for an end-to-end answer.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>

#include <taut/search/arc_search.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify_arcs.h>

#include "mazes.h"

namespace {

using namespace taut;
using bench::opened_maze;

constexpr double kRadius = 0.3;

Point corner(int cells) { return {cells - 0.5, cells - 0.5}; }

void BM_TangentGraph(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const World world = opened_maze(cells, 0.1);
  ArcSearchResult result;
  std::size_t legs = 0;
  for (auto _ : state) {
    const TangentGraph graph(FreeSpace(world), kRadius);
    result = arc_search(graph, {0.5, 0.5}, corner(cells));
    legs = graph.leg_count();
  }
  const Gates gates{FreeSpace(world)};
  if (result.status != DiscStatus::found || !verify_arcs(result.path, gates, {0.5, 0.5}, corner(cells)).valid)
    state.SkipWithError("wrong answer");
  state.counters["legs"] = static_cast<double>(legs);
  state.counters["length"] = result.path.value();
}

void BM_Query(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const TangentGraph graph(FreeSpace(opened_maze(cells, 0.1)), kRadius);
  for (auto _ : state)
    if (arc_search(graph, {0.5, 0.5}, corner(cells)).status != DiscStatus::found) state.SkipWithError("wrong answer");
}

/// Its length is at most 0.121 % of the radius an arc longer, and never shorter.
void BM_InflatedPolygon(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const World world = opened_maze(cells, 0.1);
  double length = 0;
  for (auto _ : state) {
    const auto path = shortest_path(FreeSpace(world, Footprint::disc(kRadius)), {0.5, 0.5}, corner(cells));
    length = path ? path->length.value() : 0;
  }
  const ArcSearchResult disc = arc_search(TangentGraph(FreeSpace(world), kRadius), {0.5, 0.5}, corner(cells));
  if (length < disc.path.length.lo) state.SkipWithError("wrong answer");
  state.counters["length"] = length;
}

/// The inside of a ring whose corners lie almost on a circle: nearly all see each other, hardly any are joined.
World noisy_ring(std::int64_t corners) {
  Ring ring;
  std::uint64_t state = 1;
  for (std::int64_t i = 0; i < corners; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double angle = 2 * M_PI * double(i) / double(corners), reach = 100 + 0.01 * double(state >> 40) / (1 << 24);
    ring.push_back(
        {std::round(1000 * reach * std::cos(angle)) / 1000, std::round(1000 * reach * std::sin(angle)) / 1000});
  }
  WorldParts parts;
  for (std::size_t i = 0; i < ring.size(); ++i) parts.walls.push_back({ring[i], ring[(i + 1) % ring.size()], 0, 0});
  return World(parts);
}

void BM_NoisyRing(benchmark::State& state) {
  const FreeSpace space(noisy_ring(state.range(0)));
  std::size_t legs = 0;
  for (auto _ : state) legs = TangentGraph(space, 0.01).leg_count();
  if (legs < static_cast<std::size_t>(state.range(0))) state.SkipWithError("legs are missing");
  state.counters["legs"] = static_cast<double>(legs);
}

BENCHMARK(BM_NoisyRing)->Arg(512)->Arg(2048)->Arg(8192)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_TangentGraph)->Arg(15)->Arg(45)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Query)->Arg(15)->Arg(45)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_InflatedPolygon)->Arg(15)->Arg(45)->Arg(100)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
