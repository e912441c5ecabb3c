// What others of Debian's libraries take for steps of ours, on the same walls: uniting them (Boost.Polygon, GEOS, CGAL in
// free_space_bench), growing them by a disc (GEOS), triangulating thin ones (CGAL alone).
#include <benchmark/benchmark.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <geos_c.h>

#include <boost/polygon/polygon.hpp>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/geometry/predicates.h>

#include "mazes.h"

namespace {

using namespace taut;
using bench::opened_maze;

constexpr double kThickness = 0.25;
constexpr int kUnits = 8;  // of integers to a cell

World thick_maze(int cells) { return opened_maze(cells, 0).with_wall_thickness(kThickness); }

Box rectangle_of(const Wall& wall) {
  const double half = kThickness / 2;
  return {{std::min(wall.a.x, wall.b.x) - half, std::min(wall.a.y, wall.b.y) - half},
          {std::max(wall.a.x, wall.b.x) + half, std::max(wall.a.y, wall.b.y) + half}};
}

/// Of a perfect maze of n x n cells all but its free area (free_space_bench), with the half walls around it.
double area_of_walls(double n) { return (n + kThickness) * (n + kThickness) - (9 * n * n + 3 * (n * n - 1)) / 16; }

void require_area(benchmark::State& state, double area, double expected) {
  if (std::abs(area - expected) > 1e-9 * expected) state.SkipWithError("the walls have another area");
}

void BM_UniteByTaut(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const World world = thick_maze(cells);
  for (auto _ : state) benchmark::DoNotOptimize(FreeSpace(world).triangulation().triangles.size());
}

void BM_UniteByBoostPolygon(benchmark::State& state) {
  namespace bp = boost::polygon;
  const int cells = static_cast<int>(state.range(0));
  const World world = thick_maze(cells);
  std::vector<bp::rectangle_data<int>> rectangles;
  const auto units = [](double x) { return static_cast<int>(std::lround(x * kUnits)); };
  for (const Wall& wall : world.walls()) {
    const Box box = rectangle_of(wall);
    rectangles.emplace_back(units(box.min.x), units(box.min.y), units(box.max.x), units(box.max.y));
  }
  double area = 0;
  for (auto _ : state) {
    bp::polygon_90_set_data<int> all;
    for (const auto& rectangle : rectangles) all.insert(rectangle);
    std::vector<bp::polygon_90_with_holes_data<int>> polygons;
    all.get(polygons);
    area = 0;
    for (const auto& polygon : polygons) area += static_cast<double>(bp::area(polygon));
  }
  require_area(state, area / (kUnits * kUnits), area_of_walls(cells));
}

struct Geos {
  GEOSContextHandle_t context = GEOS_init_r();
  Geos() = default;
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;
  ~Geos() { GEOS_finish_r(context); }

  using Geometry = std::unique_ptr<GEOSGeometry, std::function<void(GEOSGeometry*)>>;
  Geometry own(GEOSGeometry* geometry) const {
    return {geometry, [context = context](GEOSGeometry* g) { GEOSGeom_destroy_r(context, g); }};
  }
  Geometry collection(int type, std::vector<GEOSGeometry*> parts) const {
    return own(GEOSGeom_createCollection_r(context, type, parts.data(), static_cast<unsigned>(parts.size())));
  }
  double area(const Geometry& geometry) const {
    double area = 0;
    GEOSArea_r(context, geometry.get(), &area);
    return area;
  }
};

void BM_UniteByGeos(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const Geos geos;
  std::vector<GEOSGeometry*> rectangles;
  const World world = thick_maze(cells);
  for (const Wall& wall : world.walls()) {
    const Box box = rectangle_of(wall);
    rectangles.push_back(GEOSGeom_createRectangle_r(geos.context, box.min.x, box.min.y, box.max.x, box.max.y));
  }
  const Geos::Geometry walls = geos.collection(GEOS_MULTIPOLYGON, rectangles);
  double area = 0;
  for (auto _ : state) area = geos.area(geos.own(GEOSUnaryUnion_r(geos.context, walls.get())));
  require_area(state, area, area_of_walls(cells));
}

constexpr double kRadius = 0.2;
constexpr double kOpened = 0.1;

/// Where the disc's centre cannot be, within the walls around the maze.
double area_of_grown(const World& world) {
  double area = (world.box().max.x - world.box().min.x) * (world.box().max.y - world.box().min.y);
  const FreeSpace space(world, Footprint::disc(kRadius));
  for (const Polygon& polygon : space.polygons()) {
    area -= ring_area(polygon.outer) / 2;
    for (const Ring& hole : polygon.holes) area -= ring_area(hole) / 2;
  }
  return area;
}

/// By a disc of 16 sides a quarter, as ours is; theirs lies in the disc, ours around it.
void BM_GrowByGeos(benchmark::State& state) {
  const Geos geos;
  std::vector<GEOSGeometry*> lines;
  const World world = opened_maze(static_cast<int>(state.range(0)), kOpened);
  for (const Wall& wall : world.walls()) {
    GEOSCoordSequence* const ends = GEOSCoordSeq_create_r(geos.context, 2, 2);
    GEOSCoordSeq_setXY_r(geos.context, ends, 0, wall.a.x, wall.a.y);
    GEOSCoordSeq_setXY_r(geos.context, ends, 1, wall.b.x, wall.b.y);
    lines.push_back(GEOSGeom_createLineString_r(geos.context, ends));
  }
  const Geos::Geometry walls = geos.collection(GEOS_MULTILINESTRING, lines);
  Geos::Geometry grown = geos.own(nullptr);
  for (auto _ : state) grown = geos.own(GEOSBuffer_r(geos.context, walls.get(), kRadius, 16));
  const Box box = world.box();
  const Geos::Geometry inside =
      geos.own(GEOSClipByRect_r(geos.context, grown.get(), box.min.x, box.min.y, box.max.x, box.max.y));
  const double expected = area_of_grown(world);
  if (std::abs(geos.area(inside) - expected) > 1e-3 * expected)
    state.SkipWithError("the grown walls have another area");
}

void BM_GrowByTaut(benchmark::State& state) {
  const World world = opened_maze(static_cast<int>(state.range(0)), kOpened);
  for (auto _ : state)
    benchmark::DoNotOptimize(FreeSpace(world, Footprint::disc(kRadius)).triangulation().triangles.size());
}

/// Walls as edges of cells: no two cross.
void BM_ThinByCgal(benchmark::State& state) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
  const int cells = static_cast<int>(state.range(0));
  const World world = opened_maze(cells, 0);
  std::vector<Cdt::Point> points;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const Wall& wall : world.walls()) {
    const double length = std::abs(wall.b.x - wall.a.x) + std::abs(wall.b.y - wall.a.y);
    const double dx = (wall.b.x - wall.a.x) / length, dy = (wall.b.y - wall.a.y) / length;
    for (double t = 0; t <= length; ++t) {
      if (t > 0) edges.emplace_back(points.size() - 1, points.size());
      points.push_back({wall.a.x + t * dx, wall.a.y + t * dy});
    }
  }
  std::size_t faces = 0;
  for (auto _ : state) {
    Cdt cdt;
    cdt.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
    faces = cdt.number_of_faces();
  }
  // Two triangles a cell: all corners of cells are ends of walls, or nearly all.
  const double whole = 2.0 * cells * cells;
  if (static_cast<double>(faces) > whole || static_cast<double>(faces) < 0.9 * whole)
    state.SkipWithError("not two triangles a cell");
}

void BM_ThinByTaut(benchmark::State& state) {
  const World world = opened_maze(static_cast<int>(state.range(0)), 0);
  for (auto _ : state) benchmark::DoNotOptimize(FreeSpace(world).triangulation().triangles.size());
}

BENCHMARK(BM_UniteByTaut)->Arg(25)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_UniteByBoostPolygon)->Arg(25)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_UniteByGeos)->Arg(25)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_GrowByTaut)->Arg(25)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_GrowByGeos)->Arg(25)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ThinByTaut)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ThinByCgal)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
