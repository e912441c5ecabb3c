// Catching a moving target: the exact planner beside the one that chooses its entry first, and beside the full dynamic programme; large maps;
// the reader.
#include <benchmark/benchmark.h>

#include <string>

#include <taut/io/worlds/read_chase_map.h>
#include <taut/robots/pursuit/chase.h>
#include <taut/robots/pursuit/chase_generator.h>
#include <taut/robots/pursuit/exact_planner.h>

#include "../tests/robots/pursuit/full_programme.h"

namespace {

using namespace taut::pursuit;

ChaseMap town(int side, int seconds) {
  return generate_chase_map({.x_size = side, .y_size = side, .seconds = seconds, .costly = true, .seed = 2});
}

// Like the large maps of contests: costs that rise towards walls, here so far that corridors have no cheap cell.
ChaseMap building(int side, int seconds) {
  return generate_chase_map({.x_size = side,
                             .y_size = side,
                             .seconds = seconds,
                             .costly = true,
                             .seed = 1,
                             .ground = ChaseGround::building,
                             .inflation = 40});
}

void run_planner(benchmark::State& state, const char* name, ChaseMap (*make)(int, int) = town) {
  const ChaseMap map = make(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const Chase chase = chase_of(map, Clock::zero);
  const NamedPlanner& planner = *chase_planner(name);
  const Cost bound = exact_plan(chase).bound;  // the optimum, unless the labels of the exact planner ran out
  ChasePlan plan;
  for (auto _ : state) plan = planner.plan(chase, {}, nullptr);
  if (plan.status == taut::SearchStatus::stopped) {  // `entry`, when its one way of least cost is late everywhere
    state.SetLabel("no plan");
    return;
  }
  if (plan.status != taut::SearchStatus::found || !verify_plan(plan, chase).empty() || plan.cost < bound ||
      (plan.optimal && plan.cost != bound))
    state.SkipWithError("a wrong plan");
  state.counters["over_bound"] = static_cast<double>(plan.cost) / static_cast<double>(bound);
  state.counters["proven"] = plan.optimal;
}
void exact(benchmark::State& state) { run_planner(state, "exact"); }
void entry(benchmark::State& state) { run_planner(state, "entry"); }
void exact_in_building(benchmark::State& state) { run_planner(state, "exact", building); }
void entry_in_building(benchmark::State& state) { run_planner(state, "entry", building); }
void first(benchmark::State& state) { run_planner(state, "first"); }

void full_programme(benchmark::State& state) {
  const ChaseMap map = town(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::optional<Cost> least;
  for (auto _ : state) least = taut::test::least_cost(map, Clock::zero);
  if (least != exact_plan(chase_of(map, Clock::zero)).cost) state.SkipWithError("the exact plan is not the least");
}

void read(benchmark::State& state) {
  const ChaseMap map = town(static_cast<int>(state.range(0)), 1000);
  const std::string text = chase_map_text(map);
  for (auto _ : state)
    if (read_chase_map(text).costs() != map.costs()) state.SkipWithError("read another map");
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

}  // namespace

BENCHMARK(exact)
    ->Args({60, 200})
    ->Args({500, 1500})
    ->Args({2000, 5000})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(entry)
    ->Args({60, 200})
    ->Args({500, 1500})
    ->Args({2000, 5000})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(exact_in_building)
    ->Args({2000, 5000})
    ->Args({5000, 5000})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(entry_in_building)
    ->Args({2000, 5000})
    ->Args({5000, 5000})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(full_programme)->Args({60, 200})->Unit(benchmark::kMillisecond);
BENCHMARK(first)->Args({2000, 5000})->Unit(benchmark::kMillisecond);
BENCHMARK(read)->Arg(2000)->Arg(5000)->Unit(benchmark::kMillisecond);
