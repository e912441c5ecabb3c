// Walls with a thickness, united: ours against CGAL's Polygon_set_2::join on the same rectangles; and the whole free space, by size.
#include <benchmark/benchmark.h>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <cmath>
#include <memory>

#include <taut/geometry/detail/obstacles.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/maze_generator.h>

namespace {

using namespace taut;

World thick_maze(int cells) {
  return world_of(std::make_shared<GridMaze>(generate_backtracker(cells, cells, 1))).with_wall_thickness(0.25);
}

/// The same maze turned by an angle whose sine and cosine are 5/13 and 12/13: no wall is axis-parallel.
World turned_maze(int cells) {
  const World straight = thick_maze(cells);
  const auto turn = [](Point p) { return Point{(12 * p.x - 5 * p.y) / 13, (5 * p.x + 12 * p.y) / 13}; };
  WorldParts parts;
  for (Wall wall : straight.walls()) parts.walls.push_back({turn(wall.a), turn(wall.b), wall.thickness, 0});
  return World(parts);
}

void unite(benchmark::State& state, const World& world) {
  const auto pieces = detail::obstacles_of(world, Footprint::point()).pieces;
  for (auto _ : state) benchmark::DoNotOptimize(detail::outline_of_union(pieces, world.box()));
  state.counters["walls"] = static_cast<double>(world.walls().size());
}

void BM_UniteStraight(benchmark::State& state) { unite(state, thick_maze(static_cast<int>(state.range(0)))); }
void BM_UniteTurned(benchmark::State& state) { unite(state, turned_maze(static_cast<int>(state.range(0)))); }

void BM_UniteStraightByCgal(benchmark::State& state) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const World world = thick_maze(static_cast<int>(state.range(0)));
  std::vector<CGAL::Polygon_2<Kernel>> rings;
  for (const auto& piece : detail::obstacles_of(world, Footprint::point()).pieces) {
    auto& ring = rings.emplace_back();
    for (const Point p : piece.ring) ring.push_back({p.x, p.y});
  }
  for (auto _ : state) {
    CGAL::Polygon_set_2<Kernel> set;
    set.join(rings.begin(), rings.end());
    benchmark::DoNotOptimize(set.number_of_polygons_with_holes());
  }
  state.counters["walls"] = static_cast<double>(world.walls().size());
}

void free_space(benchmark::State& state, const World& world) {
  std::size_t triangles = 0;
  for (auto _ : state) triangles = FreeSpace(world).triangulation().triangles.size();
  state.counters["triangles"] = static_cast<double>(triangles);
}

void BM_FreeSpaceThin(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  free_space(state, world_of(std::make_shared<GridMaze>(generate_backtracker(cells, cells, 1))));
}
void BM_FreeSpaceThick(benchmark::State& state) { free_space(state, thick_maze(static_cast<int>(state.range(0)))); }
void BM_FreeSpaceTurned(benchmark::State& state) { free_space(state, turned_maze(static_cast<int>(state.range(0)))); }

BENCHMARK(BM_UniteStraight)->Arg(25)->Arg(50)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_UniteStraightByCgal)->Arg(25)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(BM_UniteTurned)->Arg(25)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FreeSpaceThin)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FreeSpaceThick)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FreeSpaceTurned)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);

}  // namespace
