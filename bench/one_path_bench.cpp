// A single path in a world on a raster, from walls to the check: among cells, and among triangles. And what a disc that
// is larger than all corridors costs.
#include <benchmark/benchmark.h>

#include <taut/geometry/cell_plan.h>
#include <taut/search/polyanya.h>
#include <taut/search/roadmap_kinds.h>
#include <taut/search/verify.h>

#include "mazes.h"

namespace {

using namespace taut;

struct Ends {
  Point from;
  Point to;
};

Ends ends_of(const World& world, double inset) {
  const Box box = world.box();
  return {{box.min.x + inset, box.min.y + inset}, {box.max.x - inset, box.max.y - inset}};
}

/// The length; below 0 when it does not pass the check.
double among_cells(const World& world, const Ends& ends) {
  const FreeSpace space(world);
  const Goal to{ends.to, {}};
  const GraphSearchResult found = shortest_path(Polyanya::between(space, ends.from, to), ends.from, to);
  return verify_along(found.path, space, ends.from, to).valid ? found.path.length.value() : -1;
}

double among_triangles(const World& world, const Ends& ends) {
  const FreeSpace space(world);
  const Goal to{ends.to, {}};
  const Polyanya mesh(space, navmesh_between(space, ends.from, to));
  const GraphSearchResult found = shortest_path(mesh, ends.from, to);
  return verify(found.path, space, ends.from, to).valid ? found.path.length.value() : -1;
}

void one_path(benchmark::State& state, const World& world, double inset, double (*way)(const World&, const Ends&)) {
  const Ends ends = ends_of(world, inset);
  const double expected = among_triangles(world, ends);
  for (auto _ : state)
    if (way(world, ends) != expected) state.SkipWithError("the path has another length");
  state.counters["length"] = expected;
}

void BM_ThinAmongCells(benchmark::State& state) {
  one_path(state, bench::opened_maze(static_cast<int>(state.range(0)), 0), 0.5, among_cells);
}
void BM_ThinAmongTriangles(benchmark::State& state) {
  one_path(state, bench::opened_maze(static_cast<int>(state.range(0)), 0), 0.5, among_triangles);
}
void BM_OpenedAmongCells(benchmark::State& state) {
  one_path(state, bench::opened_maze(static_cast<int>(state.range(0)), 0.2), 0.5, among_cells);
}
void BM_OpenedAmongTriangles(benchmark::State& state) {
  one_path(state, bench::opened_maze(static_cast<int>(state.range(0)), 0.2), 0.5, among_triangles);
}
void BM_BlocksAmongCells(benchmark::State& state) {
  one_path(state, bench::opened_block_maze(static_cast<int>(state.range(0)), 1, 0), 1.5, among_cells);
}
void BM_BlocksAmongTriangles(benchmark::State& state) {
  one_path(state, bench::opened_block_maze(static_cast<int>(state.range(0)), 1, 0), 1.5, among_triangles);
}
BENCHMARK(BM_ThinAmongCells)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ThinAmongTriangles)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_OpenedAmongCells)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_OpenedAmongTriangles)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_BlocksAmongCells)->Arg(100)->Arg(255)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_BlocksAmongTriangles)->Arg(100)->Arg(255)->Unit(benchmark::kMillisecond);

/// Walls thick on one another: nearly all of the polygons around them is hidden.
void BM_DiscTooLarge(benchmark::State& state) {
  const World world = bench::opened_maze(static_cast<int>(state.range(0)), 0);
  for (auto _ : state)
    if (FreeSpace(world, Footprint::disc(10)).holds({0.5, 0.5})) state.SkipWithError("the disc is too large");
}
BENCHMARK(BM_DiscTooLarge)->Arg(60)->Unit(benchmark::kMillisecond);

void disc_voronoi(benchmark::State& state, bool walls) {
  const World world = bench::opened_maze(static_cast<int>(state.range(0)), 0);
  const FreeSpace space(world, Footprint::disc(0.2));
  const Ends ends = ends_of(world, 0.5);
  BuildRequest request;
  if (walls) request.from = ends.from;
  request.to.point = ends.to;
  for (auto _ : state)
    if (roadmap_kind("voronoi")->build(space, request).search(ends.from, request.to, {}).status != SearchStatus::found)
      state.SkipWithError("the disc gets through");
}
void BM_DiscOnDiagramOfWalls(benchmark::State& state) { disc_voronoi(state, true); }
void BM_DiscOnDiagramOfPolygons(benchmark::State& state) { disc_voronoi(state, false); }
BENCHMARK(BM_DiscOnDiagramOfWalls)->Arg(25)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DiscOnDiagramOfPolygons)->Arg(25)->Unit(benchmark::kMillisecond);

}  // namespace
