// Time to the first solution of a growing PRM on perfect mazes of 7 to 61 cells a side, by connection rule and sampler,
// with the seed moving on from run to run. Every answer is checked. Beside it: the exact shortest path on the same
// space, graph included.
#include <benchmark/benchmark.h>

#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/search/prm_request.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

namespace {

using namespace taut;

FreeSpace maze(const benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  return FreeSpace(world_of(std::make_shared<GridMaze>(generate_biased_maze(cells, cells, 1))));
}

bool is_valid(const GraphSearchResult& result, const FreeSpace& space) {
  const World& world = space.world();
  return result.status == SearchStatus::found && verify(result.path, space, *world.start(), world.goal()).valid;
}

/// Sums over the runs, shown as means.
class Sums {
 public:
  void add(const PrmResult& result, double optimum) {
    ratio_ += result.search.path.length.value() / optimum;
    vertices_ += static_cast<double>(result.counts.kept);
    edges_ += static_cast<double>(result.counts.edges);
    tested_ += static_cast<double>(result.counts.edges_tested);
  }

  void show(benchmark::State& state) const {
    const auto mean = [](double sum) { return benchmark::Counter(sum, benchmark::Counter::kAvgIterations); };
    state.counters["length_ratio"] = mean(ratio_);
    state.counters["vertices"] = mean(vertices_);
    state.counters["edges"] = mean(edges_);
    state.counters["tested"] = mean(tested_);
  }

 private:
  double ratio_ = 0, vertices_ = 0, edges_ = 0, tested_ = 0;
};

void first_path(benchmark::State& state, PrmPlan plan) {
  const FreeSpace space = maze(state);
  const World& world = space.world();
  const double optimum = shortest_path(space, *world.start(), world.goal())->length.value();
  Sums sums;
  for (auto _ : state) {
    const PrmResult result = prm_path(space, *world.start(), world.goal(), plan);
    state.PauseTiming();
    ++plan.roadmap.seed;
    if (!is_valid(result.search, space)) return state.SkipWithError("no valid path");
    sums.add(result, optimum);
    state.ResumeTiming();
  }
  sums.show(state);
}

PrmPlan plan(PrmSampler sampler, PrmConnection::Rule rule, bool lazy = false) {
  PrmPlan result;
  result.roadmap.sampler = sampler;
  result.roadmap.connection.rule = rule;
  result.lazy = lazy;
  return result;
}

/// What the program does when nothing else is asked for.
PrmPlan default_plan() { return plan_of({}, PrmSampler::sobol, 1, true); }

void exact_shortest(benchmark::State& state) {
  const FreeSpace space = maze(state);
  const World& world = space.world();
  for (auto _ : state) {
    const GraphSearchResult result = shortest_path(VisibilityGraph(space), *world.start(), world.goal());
    state.PauseTiming();
    if (!is_valid(result, space)) return state.SkipWithError("no valid path");
    state.ResumeTiming();
  }
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const int cells : {7, 15, 25, 41, 61}) bench->Arg(cells);
  bench->Unit(benchmark::kMillisecond);
}

using Rule = PrmConnection::Rule;

BENCHMARK_CAPTURE(first_path, sobol_visible_refined, default_plan())->Apply(sizes);
BENCHMARK_CAPTURE(first_path, uniform_nearest, plan(PrmSampler::uniform, Rule::nearest))->Apply(sizes);
BENCHMARK_CAPTURE(first_path, uniform_visible, plan(PrmSampler::uniform, Rule::visible))->Apply(sizes);
BENCHMARK_CAPTURE(first_path, uniform_star, plan(PrmSampler::uniform, Rule::star))->Apply(sizes);
BENCHMARK_CAPTURE(first_path, corners_visible, plan(PrmSampler::corners, Rule::visible))->Apply(sizes);
BENCHMARK_CAPTURE(first_path, medial_visible, plan(PrmSampler::medial, Rule::visible))->Apply(sizes);
BENCHMARK_CAPTURE(first_path, lattice_nearest, plan(PrmSampler::lattice, Rule::nearest))->Apply(sizes);
BENCHMARK_CAPTURE(first_path, uniform_nearest_lazy, plan(PrmSampler::uniform, Rule::nearest, true))->Apply(sizes);
BENCHMARK_CAPTURE(first_path, lattice_nearest_lazy, plan(PrmSampler::lattice, Rule::nearest, true))->Apply(sizes);
BENCHMARK(exact_shortest)->Apply(sizes);

}  // namespace
