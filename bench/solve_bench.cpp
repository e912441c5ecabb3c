// From walls to a checked shortest path, by size: what `taut solve` does, without reading and drawing.
#include <benchmark/benchmark.h>

#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "mazes.h"

namespace {

using namespace taut;
using bench::opened_maze;

void solve(benchmark::State& state, double opened) {
  const World world = opened_maze(static_cast<int>(state.range(0)), opened);
  for (auto _ : state) {
    const FreeSpace space(world);
    const VisibilityGraph graph(space);
    const GraphSearchResult result = shortest_path(graph, *world.start(), world.goal());
    if (result.status != SearchStatus::found || !verify(result.path, space, *world.start(), world.goal()).valid)
      state.SkipWithError("no valid path");
  }
  state.counters["walls"] = static_cast<double>(world.walls().size());
  state.counters["walls/s"] =
      benchmark::Counter(static_cast<double>(world.walls().size()), benchmark::Counter::kIsIterationInvariantRate);
  state.SetComplexityN(static_cast<benchmark::IterationCount>(world.walls().size()));
}

void BM_SolvePerfect(benchmark::State& state) { solve(state, 0); }
void BM_SolveHalfOpen(benchmark::State& state) { solve(state, 0.5); }

BENCHMARK(BM_SolvePerfect)
    ->Arg(100)
    ->Arg(200)
    ->Arg(400)
    ->Arg(700)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(BM_SolveHalfOpen)->Arg(45)->Arg(100)->Arg(200)->Unit(benchmark::kMillisecond);

/// Queries on a finished graph.
void query(benchmark::State& state, GraphAlgorithm algorithm) {
  const World world = opened_maze(static_cast<int>(state.range(0)), 0.5);
  const VisibilityGraph graph{FreeSpace(world)};
  std::size_t expanded = 0;
  for (auto _ : state) expanded = shortest_path(graph, *world.start(), world.goal(), algorithm).expanded;
  state.counters["expanded"] = static_cast<double>(expanded);
}
void BM_QueryAstar(benchmark::State& state) { query(state, GraphAlgorithm::astar); }
void BM_QueryDijkstra(benchmark::State& state) { query(state, GraphAlgorithm::dijkstra); }

BENCHMARK(BM_QueryAstar)->Arg(45)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_QueryDijkstra)->Arg(45)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);

}  // namespace
