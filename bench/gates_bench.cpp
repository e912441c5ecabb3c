// Where a disc can go, by size of maze: all gates, then single questions. Peer: the free space inflated by the disc, one radius at a time.
#include <benchmark/benchmark.h>

#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/search/disc_passage.h>

namespace {

using namespace taut;

/// A backtracker maze with a tenth of its walls taken down, walls `thickness` thick.
World opened_maze(int cells, double thickness) {
  auto maze = std::make_shared<GridMaze>(generate_backtracker(cells, cells, 1));
  open_walls(*maze, 0.1, 1);
  return world_of(maze).with_wall_thickness(thickness);
}

/// The same maze turned by an angle whose sine and cosine are 5/13 and 12/13: no wall is axis-parallel.
World turned_maze(int cells) {
  const World straight = opened_maze(cells, 0);
  const auto turn = [](Point p) { return Point{(12 * p.x - 5 * p.y) / 13, (5 * p.x + 12 * p.y) / 13}; };
  WorldParts parts;
  for (Wall wall : straight.walls()) parts.walls.push_back({turn(wall.a), turn(wall.b), wall.thickness, 0});
  return World(parts);
}

void find_gates(benchmark::State& state, const World& world) {
  const FreeSpace space(world);
  std::size_t count = 0;
  for (auto _ : state) count = Gates(space).gates().size();
  state.counters["constraints"] = static_cast<double>(space.constraints().size());
  state.counters["gates"] = static_cast<double>(count);
}

void BM_GatesThin(benchmark::State& state) { find_gates(state, opened_maze(static_cast<int>(state.range(0)), 0)); }
void BM_GatesThick(benchmark::State& state) { find_gates(state, opened_maze(static_cast<int>(state.range(0)), 0.25)); }
void BM_GatesTurned(benchmark::State& state) { find_gates(state, turned_maze(static_cast<int>(state.range(0)))); }

/// Corner to corner, by a disc that fits and by one that does not; the answers are checked.
void BM_Passage(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const Gates gates{FreeSpace(opened_maze(cells, 0.25))};
  const Point s{0.5, 0.5}, g{cells - 0.5, cells - 0.5};
  for (auto _ : state) {
    const bool right = disc_passage(gates, s, g, 0.375).status == PassageStatus::reachable &&
                       disc_passage(gates, s, g, 0.376).status == PassageStatus::start_blocked;
    if (!right) state.SkipWithError("wrong answer");
  }
}

void BM_Widest(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const Gates gates{FreeSpace(opened_maze(cells, 0.25))};
  for (auto _ : state) {
    const auto widest = widest_passage(gates, {0.5, 0.5}, {cells - 0.5, cells - 0.5});
    if (!widest || widest->radius != 0.375) state.SkipWithError("wrong answer");
  }
}

/// The peer: an inflated free space answers for one radius, to within 0.121 %.
void BM_InflatedPolygon(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const World world = opened_maze(cells, 0.25);
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
