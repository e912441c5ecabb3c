// Walls with a thickness, united: against CGAL's Polygon_set_2::join on the same rectangles; axis-parallel walls noded
// and triangulated, against what sloped ones take (an index of boxes, CGAL); and the whole free space, by size.
#include <benchmark/benchmark.h>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <cmath>
#include <memory>

#include <taut/geometry/detail/noding.h>
#include <taut/geometry/detail/obstacles.h>
#include <taut/geometry/detail/triangulate.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/occupancy_world.h>
#include <taut/geometry/predicates.h>

#include "mazes.h"

namespace {

using namespace taut;
using bench::opened_maze;

World thick_maze(int cells) { return opened_maze(cells, 0).with_wall_thickness(0.25); }

double doubled_area(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) {
    sum += ring_area(polygon.outer);
    for (const Ring& hole : polygon.holes) sum += ring_area(hole);
  }
  return sum;
}

/// Of a perfect maze of n x n cells, its walls 1/4 thick: each cell leaves a square of 3/4, each of the n^2 - 1
/// passages a rectangle of 3/4 x 1/4 more between two of them.
double free_area(double n) { return (9 * n * n + 3 * (n * n - 1)) / 16; }
double free_outline(double n) { return 3 * n * n - (n * n - 1); }

bool near(double value, double expected) { return std::abs(value - expected) <= 1e-9 * expected; }

double length(const detail::Outline& outline) {
  double sum = 0;
  for (const detail::Edge& e : outline.edges) sum += std::hypot(e.b.x - e.a.x, e.b.y - e.a.y);
  return sum;
}

/// `rim`: the length of the outline round the whole maze, when the world shows it.
void unite(benchmark::State& state, const World& world, double rim) {
  const auto pieces = detail::obstacles_of(world, Footprint::point()).pieces;
  const double expected = free_outline(static_cast<double>(state.range(0))) + rim;
  detail::Outline outline;
  for (auto _ : state) benchmark::DoNotOptimize(outline = detail::outline_of_union(pieces, world.box()));
  if (!near(length(outline), expected)) state.SkipWithError("the outline has another length than the walls of a maze");
  state.counters["walls"] = static_cast<double>(world.walls().size());
}

void BM_UniteStraight(benchmark::State& state) { unite(state, thick_maze(static_cast<int>(state.range(0))), 0); }
void BM_UniteTurned(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const World world = bench::turned(thick_maze(cells));
  const Box box = world.box();  // the outline of an open world is part of it
  unite(state, world, 4 * (cells + 0.25) + 2 * (box.max.x - box.min.x + box.max.y - box.min.y));
}

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
    // The walls of a perfect maze hang together around one connected inside.
    if (set.number_of_polygons_with_holes() != 1) state.SkipWithError("the walls are one polygon");
  }
  state.counters["walls"] = static_cast<double>(world.walls().size());
}

void free_space(benchmark::State& state, const World& world, double area) {
  std::size_t triangles = 0;
  for (auto _ : state) {
    const FreeSpace space(world);
    triangles = space.triangulation().triangles.size();
    if (!near(doubled_area(space.polygons()), 2 * area)) state.SkipWithError("the free space has another area");
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

void BM_FreeSpaceThin(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  free_space(state, world_of(std::make_shared<GridMaze>(generate_backtracker(cells, cells, 1))), double(cells) * cells);
}
void BM_FreeSpaceThick(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  free_space(state, thick_maze(cells), free_area(cells));
}
void BM_FreeSpaceTurned(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const World world = bench::turned(thick_maze(cells));
  const Box box = world.box();
  const double all = (box.max.x - box.min.x) * (box.max.y - box.min.y), maze = (cells + 0.25) * (cells + 0.25);
  free_space(state, world, all - maze + free_area(cells));
}

/// A grid map with corridors one cell wide: the rooms and passages of a perfect maze.
World block_map(int cells) {
  const GridMaze maze = generate_backtracker(cells, cells, 1);
  const auto side = static_cast<std::uint32_t>(2 * cells + 1);
  OccupancyGrid grid{side, side, std::vector<std::uint8_t>(std::size_t{side} * side, 1)};
  const auto open = [&](int x, int y) {
    grid.blocked[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)] = 0;
  };
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      open(2 * x + 1, 2 * y + 1);
      if (!maze.wall({x, y}, Side::east)) open(2 * x + 2, 2 * y + 1);
      if (!maze.wall({x, y}, Side::north)) open(2 * x + 1, 2 * y + 2);
    }
  return world_of(grid);
}

double side_lengths(const Polygon& polygon) {
  double sum = 0;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      sum += std::hypot(ring[i].x - ring[j].x, ring[i].y - ring[j].y);
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  return sum;
}

/// Rooms, and a passage less than rooms.
double block_area(double cells) { return 2 * cells * cells - 1; }

void BM_FreeSpaceBlocks(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  free_space(state, block_map(cells), block_area(cells));
}

/// What rings into noding save: convex pieces of the same blocks, and their union.
void BM_UnitePiecesOfBlocks(benchmark::State& state) {
  const World world = block_map(static_cast<int>(state.range(0)));
  const Box box = world.box();
  double sides = -2 * (box.max.x - box.min.x + box.max.y - box.min.y);  // the rim, on which blocks lie outside too
  for (const Area& solid : world.solids()) sides += side_lengths(solid.polygon);
  detail::Outline outline;
  for (auto _ : state)
    outline = detail::outline_of_union(detail::obstacles_of(world, Footprint::point()).pieces, world.box());
  if (!near(length(outline), sides)) state.SkipWithError("the outline has another length than the blocks");
}

std::vector<detail::Edge> maze_edges(int cells) {
  std::vector<detail::Edge> edges;
  const World world = opened_maze(cells, 0);
  for (std::uint32_t i = 0; i < world.walls().size(); ++i)
    edges.push_back({world.walls()[i].a, world.walls()[i].b, 0, i});
  return edges;
}

template <class Triangulate>
void triangulate(benchmark::State& state, const Triangulate& triangulate) {
  const int cells = static_cast<int>(state.range(0));
  const DecimalUnit unit(Box{{0, 0}, {double(cells), double(cells)}});
  const std::vector<detail::Edge> edges = detail::node(maze_edges(cells), unit).edges;
  detail::Mesh mesh;
  for (auto _ : state) mesh = triangulate(edges);
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangulation.triangles) {
    const auto& p = mesh.triangulation.points;
    area += ring_area({p[a], p[b], p[c]});
  }
  if (!near(area, 2.0 * cells * cells)) state.SkipWithError("the triangles have another area than the maze");
  state.counters["triangles"] = static_cast<double>(mesh.triangulation.triangles.size());
}
void BM_TriangulateAxisParallel(benchmark::State& state) {
  triangulate(state, [](const auto& edges) { return detail::triangulate_axis_parallel(edges).value(); });
}
void BM_TriangulateByCgal(benchmark::State& state) {
  triangulate(state, [](const auto& edges) { return detail::triangulate_general(edges); });
}

template <class Node>
void node(benchmark::State& state, const Node& node) {
  const int cells = static_cast<int>(state.range(0));
  const DecimalUnit unit(Box{{0, 0}, {double(cells), double(cells)}});
  const std::vector<detail::Edge> edges = maze_edges(cells);
  const std::size_t known = detail::node_general(edges, unit).edges.size();
  std::size_t pieces = 0;
  for (auto _ : state) pieces = node(edges, unit).edges.size();
  if (pieces != known) state.SkipWithError("there are more or fewer pieces");
  state.counters["pieces"] = static_cast<double>(pieces);
}
void BM_NodeAxisParallel(benchmark::State& state) {
  node(state, [](const auto& edges, const auto& unit) { return detail::node(edges, unit); });
}
void BM_NodeGeneral(benchmark::State& state) {
  node(state, [](const auto& edges, const auto& unit) { return detail::node_general(edges, unit); });
}

BENCHMARK(BM_UniteStraight)->Arg(25)->Arg(50)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_UniteStraightByCgal)->Arg(25)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(BM_UniteTurned)->Arg(25)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FreeSpaceThin)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FreeSpaceThick)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FreeSpaceBlocks)->Arg(100)->Arg(255)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_UnitePiecesOfBlocks)->Arg(100)->Arg(255)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_NodeAxisParallel)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_NodeGeneral)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_TriangulateAxisParallel)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_TriangulateByCgal)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FreeSpaceTurned)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);

}  // namespace
