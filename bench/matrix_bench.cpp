// All pairs of points at once against one search for each point (Polyanya to each of the others): CPU a
// pair. Every length of the first hundred points is compared, bit by bit.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <taut/io/worlds/read_world.h>
#include <taut/search/distance_matrix.h>
#include <taut/search/polyanya.h>

#include "mazes.h"
#include "shared_data.h"

namespace {

using namespace taut;

struct Case {
  FreeSpace space;
  std::vector<Point> points;
};

Case made(const FreeSpace& space, std::size_t count) {
  const Box box = space.world().box();
  std::mt19937_64 engine(1);
  const auto below = [&](double size) {
    return static_cast<double>(engine() % static_cast<std::uint64_t>(size)) + 0.5;
  };
  Case on{space, {}};
  while (on.points.size() < count) {
    const double x = box.min.x + below(box.max.x - box.min.x), y = box.min.y + below(box.max.y - box.min.y);
    if (space.locate({x, y}).kind != Location::Kind::outside) on.points.push_back({x, y});
  }
  return on;
}

/// Are the lengths those of single paths?
bool is_right(const Case& on) {
  const std::span<const Point> points = std::span(on.points).first(std::min<std::size_t>(100, on.points.size()));
  const std::vector<double> lengths = distance_matrix(on.space, points);
  PolyanyaSearch search{Polyanya(on.space)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto paths = search.find_each(points[i], points);
    for (std::size_t j = 0; j < points.size(); ++j)
      if (!paths[j] || paths[j]->length.value() != lengths[i * points.size() + j]) return false;
  }
  return true;
}

void count(benchmark::State& state, double pairs) {
  state.counters["us/pair"] =
      benchmark::Counter(pairs, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void matrix(benchmark::State& state, const Case& on) {
  if (!is_right(on)) return state.SkipWithError("not the length of a single path");
  const auto n = static_cast<double>(on.points.size());
  std::vector<double> lengths(on.points.size() * on.points.size());
  for (auto _ : state) distance_matrix(VisibilityGraph(on.space), on.points, lengths);
  count(state, n * n);
}

void one_by_one(benchmark::State& state, const Case& on) {
  PolyanyaSearch search{Polyanya(on.space)};
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(search.find_each(on.points[i], on.points));
    i = i + 1 == on.points.size() ? 0 : i + 1;
  }
  count(state, static_cast<double>(on.points.size()));
}

void register_case(const std::string& name, const std::function<FreeSpace()>& space) {
  const auto on = [space](std::size_t points) { return made(space(), points); };
  for (const std::size_t points : {1000, 10000})
    benchmark::RegisterBenchmark(("BM_Matrix/" + name + "/" + std::to_string(points)).c_str(),
                                 [=](benchmark::State& state) { matrix(state, on(points)); })
        ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(("BM_OneByOne/" + name + "/1000").c_str(), [=](benchmark::State& state) {
    one_by_one(state, on(1000));
  })->Unit(benchmark::kMillisecond);
}

void register_all() {
  for (const double opened : {0.0, 0.2})
    register_case(opened > 0 ? "maze100-opened" : "maze100",
                  [=] { return FreeSpace(bench::opened_maze(100, opened)); });
  const std::filesystem::path maps = bench::shared_data("movingai");
  if (maps.empty()) return;
  for (const std::string name : {"maze512-8-0", "maze512-8-0-braid20", "brc202d"})
    register_case(name, [=] { return FreeSpace(read_world_file((maps / (name + ".map.gz")).string(), {})); });
}

[[maybe_unused]] const bool kRegistered = (register_all(), true);

}  // namespace
