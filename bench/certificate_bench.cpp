// Certificates: making one, beside the search that it is of, and judging it.
#include <benchmark/benchmark.h>

#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/search/path_certificate.h>
#include <taut/search/shortest_path.h>
#include <taut/verify/judge.h>

#include "mazes.h"

namespace {

using namespace taut;

// From corner to corner, in a point.
World maze(const benchmark::State& state, double opened) {
  const auto side = static_cast<double>(state.range(0));
  return bench::opened_maze(static_cast<int>(side), opened).with_ends(Point{0.5, 0.5}, Point{side - 0.5, side - 0.5});
}

void make(benchmark::State& state, double opened) {
  const FreeSpace space(maze(state, opened));
  const auto path = shortest_path(space, *space.world().start(), *space.world().goal().point);
  std::size_t listed = 0;
  for (auto _ : state)
    listed = shortest_certificate(VisibilityGraph(space), *path, space.world().goal())->potentials.size();
  state.counters["listed"] = static_cast<double>(listed);
}

void search(benchmark::State& state, double opened) {
  const World world = maze(state, opened);
  for (auto _ : state) {
    const FreeSpace space(world);
    benchmark::DoNotOptimize(shortest_path(space, *world.start(), *world.goal().point));
  }
}

void judge(benchmark::State& state, double opened) {
  const FreeSpace space(maze(state, opened));
  const auto path = shortest_path(space, *space.world().start(), *space.world().goal().point);
  const std::string world = write_integers(space.world());
  const std::string certificate =
      certificate_text(*shortest_certificate(VisibilityGraph(space), *path, space.world().goal()), world);
  for (auto _ : state)
    if (!proof::judge(world, certificate).proven) state.SkipWithError("not proven");
}

void BM_SpaceAndSearch(benchmark::State& state) { search(state, 0.1); }
void BM_MakeCertificate(benchmark::State& state) { make(state, 0.1); }
void BM_JudgePerfect(benchmark::State& state) { judge(state, 0); }
void BM_JudgeLoops(benchmark::State& state) { judge(state, 0.1); }
void BM_JudgeHalfOpen(benchmark::State& state) { judge(state, 0.5); }

BENCHMARK(BM_SpaceAndSearch)->Arg(61)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_MakeCertificate)->Arg(61)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_JudgePerfect)->Arg(45)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_JudgeLoops)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_JudgeHalfOpen)->Arg(61)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
