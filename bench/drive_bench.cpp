// The car among roadblocks: plans, estimates repaired beside made anew, and steps beside what one who knows needs.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/detail/pose_distance.h>
#include <taut/robots/roadblocks/drivers.h>
#include <taut/robots/roadblocks/roadblock_map_generator.h>

#include "shared_data.h"

namespace taut::roadblocks {
namespace {

constexpr WallReading kPoints = WallReading::points;

/// 1, 2, 4: the shared maps of these numbers, where they are; else a generated one of the same size.
std::optional<RoadblockMap> map_of(std::int64_t which) {
  if (which > 10) return generate_roadblock_map({50, 50, 4, 10, static_cast<std::uint64_t>(which - 10)});
  const auto file = bench::shared_data("car/map_" + std::to_string(which) + ".txt");
  if (file.empty()) return std::nullopt;
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return read_roadblock_map(text.str(), file.filename().string());
}

Pose start_of(const RoadblockMap& map) { return {map.course.start.x, map.course.start.y, 0}; }

void first_plan(benchmark::State& state) {
  const auto map = map_of(state.range(0));
  if (!map) return state.SkipWithError("no such map here");
  std::size_t steps = 0, expanded = 0;
  for (auto _ : state) {
    LatticePlanner planner(map->course, kPoints);
    const DrivePlan* plan = planner.plan(start_of(*map), 0);
    if (!plan) return state.SkipWithError("no way");
    steps = plan->controls.size();
    expanded = planner.expanded();
  }
  state.counters["steps"] = static_cast<double>(steps);
  state.counters["expanded"] = static_cast<double>(expanded);
}

/// The estimate after each roadblock has closed, one after the other.
void estimates(benchmark::State& state, bool repaired) {
  const auto map = map_of(state.range(0));
  if (!map) return state.SkipWithError("no such map here");
  const Course& course = map->course;
  std::vector<detail::Obstacles> obstacles;
  std::vector<detail::DiscDistance> discs;
  std::vector<detail::PoseDistance> known;
  for (std::size_t k = 0; k <= course.roadblocks.size(); ++k) {
    obstacles.emplace_back(course, (RoadblockSet{1} << k) - 1, kPoints);
    discs.emplace_back(obstacles.back(), course.goal);
    known.emplace_back(obstacles.back(), discs.back(), course.goal);
  }
  for (auto _ : state)
    for (std::size_t k = 1; k < known.size(); ++k) {
      const detail::PoseDistance now =
          repaired ? detail::PoseDistance(known[k - 1], obstacles[k - 1], obstacles[k], discs[k])
                   : detail::PoseDistance(obstacles[k], discs[k], course.goal);
      if (now.steps_from(start_of(*map)) != known[k].steps_from(start_of(*map)))
        return state.SkipWithError("the repaired estimate differs");
    }
  state.counters["roadblocks"] = static_cast<double>(course.roadblocks.size());
}

/// All samples, planned and driven from nothing; steps beside the clairvoyant's.
void all_samples(benchmark::State& state) {
  const auto map = map_of(state.range(0));
  if (!map) return state.SkipWithError("no such map here");
  double steps = 0, bound = 0;
  std::size_t plans = 0;
  for (auto _ : state) {
    LatticePlanner planner(map->course, kPoints);
    steps = bound = 0;
    for (const Sample& sample : map->samples) {
      const Drive run = drive(map->course, sample.open, *make_driver(DriverKind::policy, planner), kPoints);
      state.PauseTiming();
      const Drive best =
          drive(map->course, sample.open, *make_driver(DriverKind::clairvoyant, planner, sample.open), kPoints);
      state.ResumeTiming();
      if (run.outcome != best.outcome) return state.SkipWithError("a sample was lost");
      if (run.outcome != Outcome::reached) continue;
      steps += static_cast<double>(run.controls.size());
      bound += static_cast<double>(best.controls.size());
    }
    plans = planner.plans();
  }
  state.counters["steps/clairvoyant"] = steps / bound;
  state.counters["searches"] = static_cast<double>(plans);
}

BENCHMARK(first_plan)->Arg(1)->Arg(2)->Arg(4)->Arg(13)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(estimates, anew, false)
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Arg(13)
    ->Arg(14)
    ->Arg(17)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(estimates, repaired, true)
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Arg(13)
    ->Arg(14)
    ->Arg(17)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(all_samples)->Arg(1)->Arg(2)->Arg(4)->Arg(13)->Arg(17)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace taut::roadblocks
