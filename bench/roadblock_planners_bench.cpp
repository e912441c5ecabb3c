// Planners of the car among many roadblocks: mean and worst steps and the time of all samples. The table in
// docs/roadblocks.md is made of it. Every sample that has a way has to be reached by all.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include <taut/robots/roadblocks/drivers.h>
#include <taut/robots/roadblocks/roadblock_map_generator.h>

namespace taut::roadblocks {
namespace {

constexpr WallReading kPoints = WallReading::points;
constexpr int kSamples = 100;

enum Planner : std::uint8_t { clairvoyant, optimist, pessimist, rollouts, uct, exact };

/// Decides with one RolloutPolicy at every sight.
class RolloutDriver : public Driver {
 public:
  explicit RolloutDriver(RolloutPolicy& policy) : policy_(policy) {}
  std::optional<double> next(const ObservedMap& map, const Pose& pose) override {
    if (!plan_ || map.unknown() != unknown_) {
      plan_ = policy_.choose(pose, map.open(), map.closed()).plan;
      unknown_ = map.unknown();
      at_ = 0;
    }
    return plan_ ? std::optional(plan_->controls[at_++]) : std::nullopt;
  }
  int replans() const override { return 0; }

 private:
  RolloutPolicy& policy_;
  const DrivePlan* plan_ = nullptr;
  RoadblockSet unknown_ = 0;
  std::size_t at_ = 0;
};

/// Steps by sample; 0 where the goal was not reached.
std::vector<std::size_t> all_samples(const RoadblockMap& map, Planner kind) {
  constexpr DriverKind kKinds[]{DriverKind::clairvoyant, DriverKind::optimist, DriverKind::pessimist};
  LatticePlanner planner(map.course, kPoints);
  std::unique_ptr<RolloutPolicy> policy;
  using Look = RolloutPolicy::Look;
  if (kind == rollouts || kind == uct)
    policy = std::make_unique<RolloutPolicy>(planner, Aim::expected, kind == uct ? Look::uct : Look::rollouts);
  std::vector<std::size_t> steps;
  for (const Sample& sample : map.samples) {
    std::unique_ptr<Driver> driver;
    if (policy)
      driver = std::make_unique<RolloutDriver>(*policy);
    else if (kind == exact)
      driver = make_driver(DriverKind::policy, planner);  // which is exact up to kExactRoadblocks
    else
      driver = make_driver(kKinds[kind], planner, sample.open);
    const Drive run = drive(map.course, sample.open, *driver, kPoints);
    steps.push_back(run.outcome == Outcome::reached ? run.controls.size() : 0);
  }
  return steps;
}

void planners(benchmark::State& state, Planner kind) {
  const int side = static_cast<int>(state.range(0)), blocks = static_cast<int>(state.range(1));
  const RoadblockMap map =
      generate_roadblock_map({side, side, blocks, kSamples, static_cast<std::uint64_t>(state.range(2))});
  std::vector<std::size_t> steps;
  for (auto _ : state) steps = all_samples(map, kind);
  static std::map<std::tuple<int, int, std::int64_t>, std::vector<std::size_t>> bounds;  // the clairvoyant's
  const auto bound = bounds.try_emplace({side, blocks, state.range(2)}, steps).first->second;
  double sum = 0, reached = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if ((steps[i] == 0) != (bound[i] == 0)) return state.SkipWithError("a sample was lost");
    sum += static_cast<double>(steps[i]);
    reached += steps[i] != 0;
  }
  state.counters["reached"] = reached;
  state.counters["mean"] = sum / std::max(reached, 1.0);
  state.counters["worst"] = static_cast<double>(*std::ranges::max_element(steps));
}

/// Side, roadblocks, seed.
void few_roadblocks(benchmark::internal::Benchmark* bench) {
  for (const int seed : {501, 502}) bench->Args({50, 8, seed});
  bench->Iterations(1)->Unit(benchmark::kMillisecond);
}

void all_maps(benchmark::internal::Benchmark* bench) {
  few_roadblocks(bench);
  for (const auto& [blocks, seed] :
       std::vector<std::pair<int, int>>{{12, 401}, {12, 302}, {16, 203}, {16, 402}, {24, 321}, {24, 403}})
    bench->Args({50, blocks, seed});
}

// The clairvoyant first: what it reaches is the measure.
BENCHMARK_CAPTURE(planners, clairvoyant, clairvoyant)->Apply(all_maps);
BENCHMARK_CAPTURE(planners, optimist, optimist)->Apply(all_maps);
BENCHMARK_CAPTURE(planners, pessimist, pessimist)->Apply(all_maps);
BENCHMARK_CAPTURE(planners, rollouts, rollouts)->Apply(all_maps);
BENCHMARK_CAPTURE(planners, uct, uct)->Apply(all_maps);
BENCHMARK_CAPTURE(planners, exact, exact)->Apply(few_roadblocks);

}  // namespace
}  // namespace taut::roadblocks
