// The visibility graph by size and kind, against what a user of CGAL would write: one Triangular_expansion_visibility_2
// region for each corner, on the same walls. (CGAL's regions are no graph yet: its vertices would still have to be
// found again.)
#include <benchmark/benchmark.h>

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>

#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "mazes.h"

namespace {

using namespace taut;
using bench::opened_maze;

/// The edges of 500 vertices, spread evenly, against FreeSpace::sees.
const char* fault_of(const Roadmap& roadmap, const FreeSpace& space) {
  const std::size_t vertices = roadmap.vertex_count(), step = vertices / 500 + 1;
  if (roadmap.edge_count() < vertices / 2) return "hardly any edges";
  for (std::size_t v = 0; v < vertices; v += step) {
    const auto u = static_cast<Roadmap::Vertex>(v);
    for (const Roadmap::Vertex w : roadmap.neighbours(u))
      if (!space.sees(roadmap.point(u), roadmap.point(w))) return "an edge between places that do not see each other";
  }
  return nullptr;
}

/// Reduced or full, the shortest path is the same: found in both, of exactly equal length, and valid.
void check_paths(benchmark::State& state, const FreeSpace& space, int cells) {
  const Point from{0.5, 0.5};
  const Goal to{Point{cells - 0.5, cells - 0.5}, {}};
  const auto path = shortest_path(VisibilityGraph(space, VisibilityKind::reduced), from, to);
  if (path.status != SearchStatus::found || !verify(path.path, space, from, to).valid)
    return state.SkipWithError("no valid path from corner to corner");
  if (cells > 100) return;  // the full graph takes its time
  const auto other = shortest_path(VisibilityGraph(space, VisibilityKind::full), from, to);
  if (other.status != SearchStatus::found || other.path.length != path.path.length)
    state.SkipWithError("the reduced graph's path is not the full graph's");
}

void build(benchmark::State& state, double opened, VisibilityKind kind) {
  const FreeSpace space(opened_maze(static_cast<int>(state.range(0)), opened));
  std::size_t edges = 0, vertices = 0;
  for (auto _ : state) {
    const VisibilityGraph graph(space, kind);
    state.PauseTiming();
    if (const char* fault = fault_of(graph.roadmap(), space)) state.SkipWithError(fault);
    state.ResumeTiming();
    edges = graph.roadmap().edge_count();
    vertices = graph.roadmap().vertex_count();
  }
  check_paths(state, space, static_cast<int>(state.range(0)));
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["edges"] = static_cast<double>(edges);
  state.counters["edges/s"] =
      benchmark::Counter(static_cast<double>(edges), benchmark::Counter::kIsIterationInvariantRate);
}

void BM_ReducedPerfect(benchmark::State& state) { build(state, 0, VisibilityKind::reduced); }
void BM_ReducedHalfOpen(benchmark::State& state) { build(state, 0.5, VisibilityKind::reduced); }
void BM_ReducedNearlyOpen(benchmark::State& state) { build(state, 0.9, VisibilityKind::reduced); }
void BM_FullPerfect(benchmark::State& state) { build(state, 0, VisibilityKind::full); }
void BM_FullHalfOpen(benchmark::State& state) { build(state, 0.5, VisibilityKind::full); }

void cgal_regions(benchmark::State& state, double opened) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;
  const FreeSpace space(opened_maze(static_cast<int>(state.range(0)), opened));
  std::vector<CGAL::Segment_2<Kernel>> segments;
  for (const Constraint& c : space.constraints()) segments.push_back({{c.a.x, c.a.y}, {c.b.x, c.b.y}});
  Arrangement walls;
  CGAL::insert_non_intersecting_curves(walls, segments.begin(), segments.end());
  std::size_t vertices = 0, failures = 0;
  for (auto _ : state) {
    const CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true> visibility(walls);
    vertices = failures = 0;
    for (auto v = walls.vertices_begin(); v != walls.vertices_end(); ++v) {
      auto edge = v->incident_halfedges();
      const auto first = edge;
      do {
        if (edge->face()->is_unbounded()) continue;
        try {
          Arrangement region;
          visibility.compute_visibility(v->point(), edge, region);
          vertices += region.number_of_vertices();
        } catch (const CGAL::Failure_exception&) {
          ++failures;
        }
      } while (++edge != first);
    }
  }
  // A region has three corners at least.
  if (vertices < 3 * walls.number_of_vertices()) state.SkipWithError("regions are missing");
  state.counters["region vertices"] = static_cast<double>(vertices);
  state.counters["failures"] = static_cast<double>(failures);
}

void BM_CgalRegionsPerfect(benchmark::State& state) { cgal_regions(state, 0); }
void BM_CgalRegionsHalfOpen(benchmark::State& state) { cgal_regions(state, 0.5); }

BENCHMARK(BM_ReducedPerfect)->Arg(45)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ReducedHalfOpen)->Arg(45)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ReducedNearlyOpen)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FullPerfect)->Arg(45)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FullHalfOpen)->Arg(45)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CgalRegionsPerfect)->Arg(45)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CgalRegionsHalfOpen)->Arg(45)->Unit(benchmark::kMillisecond);

}  // namespace
