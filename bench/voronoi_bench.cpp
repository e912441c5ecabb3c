// The Voronoi roadmap by size, beside what it stands on (CGAL's bare segment Delaunay graph) and beside Boost.Polygon's
// diagram of the same walls. Boost's takes integers only and its vertices are inexact; it has edges in solids and at
// end points still in it, as CGAL's has.
#include <benchmark/benchmark.h>

#include <boost/polygon/voronoi.hpp>

#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <taut/geometry/maze_generator.h>
#include <taut/search/clearance_search.h>

namespace bench {

struct IntPoint {
  int x;
  int y;
};

struct IntSegment {
  IntPoint a;
  IntPoint b;
};

}  // namespace bench

template <>
struct boost::polygon::geometry_concept<bench::IntPoint> {
  using type = point_concept;
};

template <>
struct boost::polygon::point_traits<bench::IntPoint> {
  using coordinate_type = int;
  static int get(const bench::IntPoint& p, orientation_2d axis) { return axis == HORIZONTAL ? p.x : p.y; }
};

template <>
struct boost::polygon::geometry_concept<bench::IntSegment> {
  using type = segment_concept;
};

template <>
struct boost::polygon::segment_traits<bench::IntSegment> {
  using coordinate_type = int;
  using point_type = bench::IntPoint;
  static point_type get(const bench::IntSegment& s, direction_1d end) { return end.to_int() ? s.b : s.a; }
};

namespace {

using namespace taut;

FreeSpace maze(std::int64_t cells, double opened) {
  auto grid = std::make_shared<GridMaze>(generate_backtracker(int(cells), int(cells), 1));
  open_walls(*grid, opened, 1);
  return FreeSpace(world_of(std::move(grid)));
}

void build(benchmark::State& state, double opened) {
  const FreeSpace space = maze(state.range(0), opened);
  std::size_t edges = 0;
  for (auto _ : state) {
    const VoronoiRoadmap map(space);
    edges = map.edges().size();
    if (!(map.max_error() < 1e-9)) state.SkipWithError("a vertex is not known well");
  }
  state.counters["pieces"] = double(space.constraints().size());
  state.counters["edges"] = double(edges);
}

void cgal_graph(benchmark::State& state, double opened) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Traits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel>;
  const FreeSpace space = maze(state.range(0), opened);
  std::vector<Point> ends;
  for (const Constraint& c : space.constraints()) ends.insert(ends.end(), {c.a, c.b});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const auto index = [&](Point p) -> std::size_t {
    return std::lower_bound(ends.begin(), ends.end(), p) - ends.begin();
  };
  std::vector<Kernel::Point_2> points;
  for (const Point p : ends) points.push_back({p.x, p.y});
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const Constraint& c : space.constraints()) pairs.push_back({index(c.a), index(c.b)});
  for (auto _ : state) {
    CGAL::Segment_Delaunay_graph_2<Traits> graph;
    graph.insert_segments(points, pairs.begin(), pairs.end());
    // A vertex for each piece and each end of one.
    if (graph.number_of_vertices() != pairs.size() + ends.size()) state.SkipWithError("sites are missing");
  }
}

void boost_diagram(benchmark::State& state, double opened) {
  const FreeSpace space = maze(state.range(0), opened);
  std::vector<bench::IntSegment> segments;
  for (const Constraint& c : space.constraints())
    segments.push_back({{int(c.a.x), int(c.a.y)}, {int(c.b.x), int(c.b.y)}});
  for (auto _ : state) {
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(segments.begin(), segments.end(), &diagram);
    if (diagram.num_cells() < segments.size()) state.SkipWithError("cells are missing");
  }
}

/// What a user waits for who has a maze and wants the largest disc: diagram and search.
void build_and_search(benchmark::State& state, double opened) {
  const FreeSpace space = maze(state.range(0), opened);
  const double far = double(state.range(0)) - 0.5;
  for (auto _ : state) {
    const auto path = ClearanceSearch(VoronoiRoadmap(space), {0.5, 0.5}, {far, far}).widest();
    if (!path || path->pinch.clearance != 0.5) state.SkipWithError("a maze of unit cells has corridors of width 1");
  }
}

void widest(benchmark::State& state, double opened) {
  const FreeSpace space = maze(state.range(0), opened);
  const VoronoiRoadmap map(space);
  const double far = double(state.range(0)) - 0.5;
  for (auto _ : state) {
    const auto path = ClearanceSearch(map, {0.5, 0.5}, {far, far}).widest();
    if (!path || path->pinch.clearance != 0.5) state.SkipWithError("a maze of unit cells has corridors of width 1");
  }
}

#define TAUT_SIZES ->Arg(10)->Arg(30)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond)
BENCHMARK_CAPTURE(build, perfect, 0.0) TAUT_SIZES;
BENCHMARK_CAPTURE(build, half_open, 0.5) TAUT_SIZES;
BENCHMARK_CAPTURE(build_and_search, perfect, 0.0) TAUT_SIZES;
BENCHMARK_CAPTURE(build_and_search, half_open, 0.5) TAUT_SIZES;
BENCHMARK_CAPTURE(cgal_graph, perfect, 0.0) TAUT_SIZES;
BENCHMARK_CAPTURE(cgal_graph, half_open, 0.5) TAUT_SIZES;
BENCHMARK_CAPTURE(boost_diagram, perfect, 0.0) TAUT_SIZES;
BENCHMARK_CAPTURE(boost_diagram, half_open, 0.5) TAUT_SIZES;
BENCHMARK_CAPTURE(widest, perfect, 0.0) TAUT_SIZES;
BENCHMARK_CAPTURE(widest, half_open, 0.5) TAUT_SIZES;

}  // namespace
