// Where a disc can go, by size of maze: all gates, then single questions. Peer: the free space inflated by the disc,
// one radius at a time.
#include <benchmark/benchmark.h>

#include <taut/search/disc_passage.h>

#include "mazes.h"

namespace {

using namespace taut;

World thick_maze(int cells) { return bench::opened_maze(cells, 0.1).with_wall_thickness(0.25); }

void find_gates(benchmark::State& state, const World& world) {
  const FreeSpace space(world);
  std::size_t count = 0;
  for (auto _ : state) count = Gates(space).gates().size();
  state.counters["constraints"] = static_cast<double>(space.constraints().size());
  state.counters["gates"] = static_cast<double>(count);
}

void BM_GatesThin(benchmark::State& state) {
  find_gates(state, bench::opened_maze(static_cast<int>(state.range(0)), 0.1));
}
void BM_GatesThick(benchmark::State& state) { find_gates(state, thick_maze(static_cast<int>(state.range(0)))); }
void BM_GatesTurned(benchmark::State& state) {
  find_gates(state, bench::turned(bench::opened_maze(static_cast<int>(state.range(0)), 0.1)));
}

/// Corner to corner, by a disc that fits and by one that does not; the answers are checked.
void BM_Passage(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const Gates gates{FreeSpace(thick_maze(cells))};
  const Point s{0.5, 0.5}, g{cells - 0.5, cells - 0.5};
  for (auto _ : state) {
    const bool right = disc_passage(gates, s, g, 0.375).status == DiscStatus::found &&
                       disc_passage(gates, s, g, 0.376).status == DiscStatus::start_blocked;
    if (!right) state.SkipWithError("wrong answer");
  }
}

void BM_Widest(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const Gates gates{FreeSpace(thick_maze(cells))};
  for (auto _ : state) {
    const auto widest = widest_passage(gates, {0.5, 0.5}, {cells - 0.5, cells - 0.5});
    if (!widest || widest->radius != 0.375) state.SkipWithError("wrong answer");
  }
}

/// The peer: an inflated free space answers for one radius, to within 0.121 %.
void BM_InflatedPolygon(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const World world = thick_maze(cells);
  for (auto _ : state) {
    const FreeSpace space(world, Footprint::disc(0.3));
    const auto part = [&](Point p) { return space.component(space.locate(p).triangle); };
    if (part({0.5, 0.5}) != part({cells - 0.5, cells - 0.5})) state.SkipWithError("wrong answer");
  }
}

BENCHMARK(BM_GatesThin)->Arg(25)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_GatesThick)->Arg(25)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_GatesTurned)->Arg(25)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Passage)->Arg(25)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Widest)->Arg(25)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_InflatedPolygon)->Arg(25)->Arg(100)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
