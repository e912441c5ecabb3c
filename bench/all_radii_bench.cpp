// Discs of any radius from one index: built, the graph of a radius, and paths with arcs between random places, verified.
// Today's way beside each: a TangentGraph for one radius, and a search in it that begins from nothing.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <taut/roadmaps/all_radii.h>
#include <taut/search/arc_bounds.h>
#include <taut/search/arc_search.h>
#include <taut/search/verify_arcs.h>

#include "mazes.h"

namespace {

using namespace taut;

World world_of(std::int64_t kind) { return kind == 0 ? bench::opened_maze(100, 0.1) : bench::opened_maze(60, 0.5); }

constexpr double kRadius = 0.3;

std::vector<std::array<Point, 2>> queries(const World& world) {
  std::mt19937_64 random(2);
  const auto cells = static_cast<std::uint64_t>(world.box().max.x);
  const auto place = [&] { return static_cast<double>(random() % cells) + 0.3 + 0.4 * double(random() % 1024) / 1024; };
  std::vector<std::array<Point, 2>> result(400);
  for (auto& [s, g] : result) {
    s.x = place();
    s.y = place();
    g.x = place();
    g.y = place();
  }
  return result;
}

/// A radius that was not used before.
double fresh(std::int64_t i) { return 0.2 + 0.25 * static_cast<double>(i * 617 % 1000 + 1) / 1001; }

void BM_Built(benchmark::State& state) {
  const FreeSpace space(world_of(state.range(0)));
  std::size_t legs = 0;
  for (auto _ : state) legs = AllRadii(space).leg_count();
  state.counters["legs"] = static_cast<double>(legs);
}

void BM_OneRadius(benchmark::State& state) {
  const FreeSpace space(world_of(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(TangentGraph(space, kRadius));
}

void BM_AtRadius(benchmark::State& state) {
  const AllRadii all{FreeSpace(world_of(state.range(0)))};
  std::int64_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(all.at_radius(fresh(i++)));
}

void BM_PathNewRadius(benchmark::State& state) {
  const World world = world_of(state.range(0));
  const AllRadii all{FreeSpace(world)};
  const auto ends = queries(world);
  for (std::int64_t i = 0; i < 8; ++i) {
    const auto& [s, g] = ends[static_cast<std::size_t>(i)];
    const ArcSearchResult ours = arc_search(all, fresh(i), s, g), theirs = arc_search(all.at_radius(fresh(i)), s, g);
    if (ours.status != theirs.status || std::abs(ours.path.value() - theirs.path.value()) > 1e-9)
      state.SkipWithError("the answers differ");
  }
  std::int64_t i = 0;
  for (auto _ : state) {
    const auto& [s, g] = ends[static_cast<std::size_t>(i) % ends.size()];
    benchmark::DoNotOptimize(arc_search(all, fresh(i++), s, g));
  }
}

void BM_Bound(benchmark::State& state) {
  const World world = world_of(state.range(0));
  ArcBounds bounds(AllRadii(FreeSpace(world)).at_radius(kRadius), kRadius + 0.02);
  const auto ends = queries(world);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [s, g] = ends[i++ % ends.size()];
    benchmark::DoNotOptimize(bounds.length_at_least(kRadius + 0.01, s, g));
  }
}

void BM_GraphAndPath(benchmark::State& state) {
  const World world = world_of(state.range(0));
  const AllRadii all{FreeSpace(world)};
  const auto ends = queries(world);
  std::int64_t i = 0;
  for (auto _ : state) {
    const auto& [s, g] = ends[static_cast<std::size_t>(i) % ends.size()];
    benchmark::DoNotOptimize(ArcQueries(all.at_radius(fresh(i++))).find(s, g));
  }
}

void ask(benchmark::State& state, ArcQueries& asked) {
  const auto ends = queries(asked.graph().space().world());
  const Gates gates(asked.graph().space());
  for (std::size_t i = 0; i < 20; ++i) {
    const auto& [s, g] = ends[i];
    const ArcSearchResult ours = asked.find(s, g), theirs = arc_search(asked.graph(), s, g);
    if (ours.status != theirs.status ||
        (ours.status == DiscStatus::found && !verify_arcs(ours.path, gates, s, g).valid))
      state.SkipWithError("the answers differ");
  }
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [s, g] = ends[i++ % ends.size()];
    benchmark::DoNotOptimize(asked.find(s, g));
  }
}

void BM_Path(benchmark::State& state) {
  ArcQueries asked(AllRadii(FreeSpace(world_of(state.range(0)))).at_radius(kRadius));
  asked.prepare();
  ask(state, asked);
}

void BM_PathFromNothing(benchmark::State& state) {
  const World world = world_of(state.range(0));
  const TangentGraph graph(FreeSpace(world), kRadius);
  const auto ends = queries(world);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [s, g] = ends[i++ % ends.size()];
    benchmark::DoNotOptimize(arc_search(graph, s, g));
  }
}

BENCHMARK(BM_Built)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_OneRadius)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_AtRadius)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PathNewRadius)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_GraphAndPath)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Bound)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Path)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_PathFromNothing)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);

}  // namespace
