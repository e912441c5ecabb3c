// Where a disc of any radius can go: one index, built once and asked between random points. Peer: the chains of gates
// (disc_passage, widest_passage), which go through all gates for each question. Answers are compared with the peer's.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include <taut/search/passage_index.h>

#include "mazes.h"

namespace {

using namespace taut;

/// A noisy ring of corners: one large face inside that no gate divides.
World noisy_ring(int corners) {
  std::mt19937_64 random(1);
  WorldParts parts;
  std::vector<Point> at;
  for (int i = 0; i < corners; ++i) {
    const double radius = 40 + static_cast<double>(random() % 1024) / 1024, angle = 2 * M_PI * i / corners;
    at.push_back({50 + radius * std::cos(angle), 50 + radius * std::sin(angle)});
  }
  for (int i = 0; i < corners; ++i) parts.walls.push_back({at[i], at[(i + 1) % corners], 0, 0});
  return World(parts);
}

World world_of(int kind) {
  switch (kind) {
    case 0: return bench::opened_maze(100, 0.1);
    case 1: return bench::opened_maze(60, 0.5);
    case 2: return bench::opened_maze(60, 0.3).with_wall_thickness(0.25);
    case 3: return noisy_ring(2048);
    default: return bench::opened_maze(300, 0.1);
  }
}

struct Questions {
  explicit Questions(const FreeSpace& space) {
    std::mt19937_64 random(2);
    const Box box = space.world().box();
    const auto part = [&] { return static_cast<double>(random() % (1u << 30)) / (1u << 30); };
    while (points.size() < 2000) {
      const Point p{box.min.x + part() * (box.max.x - box.min.x), box.min.y + part() * (box.max.y - box.min.y)};
      if (space.locate(p).kind == Location::Kind::triangle) points.push_back(p);
    }
  }
  Point next() { return points[at++ % points.size()]; }

  std::vector<Point> points;
  std::size_t at = 0;
};

constexpr double kRadius = 0.3;

bool agrees(const PassageIndex& index, Questions questions) {
  for (int i = 0; i < 40; ++i) {
    const Point s = questions.next(), g = questions.next();
    const auto ours = index.widest(s, g), theirs = widest_passage(index.gates(), s, g);
    if (ours.has_value() != theirs.has_value() || (ours && ours->radius != theirs->radius)) return false;
    if (index.passes(s, g, kRadius) != disc_passage(index.gates(), s, g, kRadius).status) return false;
  }
  return true;
}

void BM_Built(benchmark::State& state) {
  const FreeSpace space(world_of(static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(PassageIndex(space));
  state.counters["gates"] = static_cast<double>(Gates(space).gates().size());
}

/// Beyond the gates.
void BM_BuiltOnGates(benchmark::State& state) {
  const Gates gates{FreeSpace(world_of(static_cast<int>(state.range(0))))};
  for (auto _ : state) benchmark::DoNotOptimize(PassageIndex(gates));
}

template <class Ask>
void ask(benchmark::State& state, Ask&& one) {
  const FreeSpace space(world_of(static_cast<int>(state.range(0))));
  const PassageIndex index(space);
  Questions questions(space);
  if (!agrees(index, questions)) state.SkipWithError("the answers differ");
  for (auto _ : state) {
    const Point s = questions.next(), g = questions.next();
    one(index, s, g);
  }
}

void BM_Reachable(benchmark::State& state) {
  ask(state,
      [](const PassageIndex& index, Point s, Point g) { benchmark::DoNotOptimize(index.passes(s, g, kRadius)); });
}
void BM_Widest(benchmark::State& state) {
  ask(state, [](const PassageIndex& index, Point s, Point g) { benchmark::DoNotOptimize(index.widest(s, g)); });
}
void BM_ReachableByChains(benchmark::State& state) {
  ask(state, [](const PassageIndex& index, Point s, Point g) {
    benchmark::DoNotOptimize(disc_passage(index.gates(), s, g, kRadius));
  });
}
void BM_WidestByChains(benchmark::State& state) {
  ask(state, [](const PassageIndex& index, Point s, Point g) {
    benchmark::DoNotOptimize(widest_passage(index.gates(), s, g));
  });
}

BENCHMARK(BM_Built)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_BuiltOnGates)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Reachable)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Widest)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ReachableByChains)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_WidestByChains)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);

}  // namespace
