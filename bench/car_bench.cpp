// Value iteration: sweeps on arrays against a plain loop over states, the same answer to the bit. And drives of all
// planners over the samples of a map: time of a drive (nearly all of it is planning), steps, share of samples reached;
// each drive that reached is asked to be free of collisions by the simulator's rules.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/drivers.h>
#include <taut/robots/roadblocks/peers.h>
#include <taut/robots/roadblocks/value_iteration.h>

#include "shared_data.h"

namespace {

using namespace taut::roadblocks;

std::optional<RoadblockMap> map_in(const std::string& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return taut::read_roadblock_map(text.str(), file);
}

/// What the arrays replace: all states by the sweep before, one after the other.
Values plain_loop(const ValueGrid& grid) {
  Values values;
  values.of.assign(grid.size(), ValueGrid::kNever);
  for (std::size_t s = 0; s < grid.size(); ++s)
    if (grid.is_goal(s)) values.of[s] = 0;
  std::vector<double> fresh = values.of;
  const std::vector<double>& straight = grid.costs(Action::straight);
  const std::vector<double>& plus = grid.costs(Action::turn_plus);
  const std::vector<double>& minus = grid.costs(Action::turn_minus);
  const std::size_t plane = grid.size() / ValueGrid::kHeadings;
  for (bool changed = true; changed; ++values.sweeps) {
    changed = false;
    for (std::size_t k = 0; k < ValueGrid::kHeadings; ++k) {
      const std::ptrdiff_t step = ValueGrid::kSteps[k][1] * grid.columns() + ValueGrid::kSteps[k][0];
      const double* turned_plus = values.of.data() + (k + 1) % ValueGrid::kHeadings * plane;
      const double* turned_minus = values.of.data() + (k + ValueGrid::kHeadings - 1) % ValueGrid::kHeadings * plane;
      for (std::size_t p = 0; p < plane; ++p) {
        const std::size_t s = k * plane + p;
        double least = std::min(values.of[s], std::min(plus[s] + turned_plus[p], minus[s] + turned_minus[p]));
        if (straight[s] != ValueGrid::kNever)  // or the step leads out of the grid
          least =
              std::min(least, straight[s] + values.of[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(s) + step)]);
        changed = changed || least != values.of[s];
        fresh[s] = least;
      }
    }
    values.of.swap(fresh);
  }
  return values;
}

void sweep(benchmark::State& state, Values (*iterate)(const ValueGrid&)) {
  const RoadblockMap map = *map_in(TAUT_DATA_DIR "/car/lane.txt");
  const ValueGrid grid(map.course, 0, WallReading::points, static_cast<int>(state.range(0)));
  if (iterate(grid).of != plain_loop(grid).of) return state.SkipWithError("not the values of the plain loop");
  int sweeps = 0;
  for (auto _ : state) sweeps += iterate(grid).sweeps;
  state.counters["states/s"] =
      benchmark::Counter(static_cast<double>(sweeps) * static_cast<double>(grid.size()), benchmark::Counter::kIsRate);
  state.counters["sweeps"] = static_cast<double>(sweeps) / static_cast<double>(state.iterations());
}

void BM_SweepPlainLoop(benchmark::State& state) { sweep(state, plain_loop); }
void BM_SweepAtOnce(benchmark::State& state) {
  sweep(state, [](const ValueGrid& grid) { return value_iteration(grid, Sweeping::at_once); });
}
void BM_SweepInPlace(benchmark::State& state) {
  sweep(state, [](const ValueGrid& grid) { return value_iteration(grid, Sweeping::in_place); });
}
BENCHMARK(BM_SweepPlainLoop)->Arg(1)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SweepAtOnce)->Arg(1)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SweepInPlace)->Arg(1)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);

Drive driven(const RoadblockMap& map, const Sample& sample, const Peer* peer) {
  if (peer) {
    const auto driver = peer->make(map.course, WallReading::points, 1 + static_cast<std::uint64_t>(sample.number));
    return drive(map.course, sample.open, *driver, WallReading::points);
  }
  LatticePlanner planner(map.course,
                         WallReading::points);  // anew, as for the others: nothing kept from sample to sample
  return drive(map.course, sample.open, *make_driver(DriverKind::policy, planner), WallReading::points);
}

/// At most this many samples of each set of open roadblocks; the trees draw anew for each.
constexpr int kAlike = 3;

std::vector<Sample> some(const std::vector<Sample>& all) {
  std::vector<Sample> chosen;
  std::map<RoadblockSet, int> alike;
  for (const Sample& sample : all)
    if (++alike[sample.open] <= kAlike) chosen.push_back(sample);
  return chosen;
}

void drives(benchmark::State& state, const std::string& file, const Peer* peer) {
  const auto map = map_in(file);
  if (!map) return state.SkipWithError("the map is not there");
  double steps = 0, reached = 0, driven_samples = 0, worst = 0;
  for (auto _ : state)
    for (const Sample& sample : some(map->samples)) {
      const Drive run = driven(*map, sample, peer);
      if (run.outcome == Outcome::collision) return state.SkipWithError("a collision");
      ++driven_samples;
      if (run.outcome != Outcome::reached) continue;
      ++reached;
      steps += static_cast<double>(run.controls.size());
      worst = std::max(worst, static_cast<double>(run.controls.size()));
    }
  state.counters["reached"] = reached / driven_samples;
  state.counters["steps"] = steps / reached;
  state.counters["worst"] = worst;
  state.counters["drive_s"] =
      benchmark::Counter(driven_samples, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

const bool kRegistered = [] {
  const auto add = [](const std::string& name, const std::string& file, const Peer* peer) {
    benchmark::RegisterBenchmark(("BM_Drive/" + name + "/" + std::filesystem::path(file).stem().string()).c_str(),
                                 [file, peer](benchmark::State& state) { drives(state, file, peer); })
        ->Unit(benchmark::kSecond)
        ->Iterations(1);
  };
  std::vector<std::string> maps{TAUT_DATA_DIR "/car/lane.txt"};
  for (const char* map : {"car/map_1.txt", "car/map_2.txt", "car/map_4.txt"})
    if (const auto file = taut::bench::shared_data(map); !file.empty()) maps.push_back(file.string());
  for (const std::string& map : maps) {
    add("policy", map, nullptr);
    for (const Peer& peer : peers()) add(std::string(peer.name), map, &peer);
  }
  return true;
}();

}  // namespace
