// Polyanya against the visibility graph, built for a query or at hand, and Boost.Graph's A* on the cell graph (through
// cell_search, whose answers are grid answers: longer). Mazes by size with a tenth of the inner walls taken down, and
// grid maps of others where they are present. All exact answers are compared exactly, those of the grid maps with the
// lengths published for the reference implementation too.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <string>

#include <taut/io/worlds/query_lines.h>
#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/cell_graph.h>
#include <taut/search/cell_search.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>

#include "mazes.h"
#include "shared_data.h"

namespace {

using namespace taut;
using bench::opened_maze;

struct Pair {
  Point from, to;
  double expected = -1;
};

struct Case {
  FreeSpace space;
  std::vector<Pair> pairs;
};

constexpr double kOpened = 0.1;
constexpr std::size_t kLandmarks = 8;

Case maze(int cells, double opened) {
  Case made{FreeSpace(opened_maze(cells, opened)), {}};
  std::mt19937_64 engine(5);
  const auto place = [&] {
    const double x = static_cast<double>(engine() % static_cast<unsigned>(cells)) + 0.5,
                 y = static_cast<double>(engine() % static_cast<unsigned>(cells)) + 0.5;
    return Point{x, y};
  };
  for (int n = 0; n < 100; ++n) {
    const Point from = place(), to = place();
    made.pairs.push_back({from, to, -1});
  }
  return made;
}

const Case& maze_case(benchmark::State& state, double opened) {
  static std::map<std::pair<int, double>, Case> cases;
  const int cells = static_cast<int>(state.range(0));
  auto at = cases.find({cells, opened});
  if (at == cases.end()) at = cases.emplace(std::pair{cells, opened}, maze(cells, opened)).first;
  return at->second;
}

void count(benchmark::State& state, const Case& on, std::size_t expanded, std::size_t queries) {
  state.counters["triangles"] = static_cast<double>(on.space.triangulation().triangles.size());
  state.counters["expanded/query"] = static_cast<double>(expanded) / static_cast<double>(queries);
  state.counters["expansions/s"] = benchmark::Counter(static_cast<double>(expanded), benchmark::Counter::kIsRate);
}

/// Is every answer the exact one?
bool is_right(const Case& on, std::size_t pairs) {
  const VisibilityGraph graph(on.space);
  PolyanyaSearch search{Polyanya(on.space)};
  for (std::size_t i = 0; i < std::min(pairs, on.pairs.size()); ++i) {
    const Pair& pair = on.pairs[i];
    search.find(pair.from, pair.to);
    if (search.result().path.length != shortest_path(graph, pair.from, {pair.to, {}}).path.length) return false;
  }
  return true;
}

/// `by_trees`: where one way alone leads, along trees of portals; else as on a mesh for one query.
void query(benchmark::State& state, const Case& on, std::size_t checked, std::size_t landmarks = 0,
           bool by_trees = true, bool with_graph = false) {
  if (!is_right(on, checked)) return state.SkipWithError("not the exact length");
  const Polyanya plain = by_trees ? Polyanya(on.space) : Polyanya(on.space, navmesh(on.space));
  const Polyanya bare = with_graph ? plain.with_graph() : plain;
  PolyanyaSearch search(landmarks > 0 ? bare.with_landmarks(landmarks) : bare);
  std::size_t i = 0, expanded = 0, queries = 0;
  for (auto _ : state) {
    const Pair& pair = on.pairs[i];
    search.find(pair.from, pair.to);
    if (pair.expected >= 0 && !(std::abs(search.length() - pair.expected) <= 1e-6))
      return state.SkipWithError("not the published length");
    expanded += search.expanded();
    ++queries;
    i = i + 1 == on.pairs.size() ? 0 : i + 1;
  }
  count(state, on, expanded, queries);
}

void BM_Query(benchmark::State& state) { query(state, maze_case(state, kOpened), 20); }
void BM_QueryPerfect(benchmark::State& state) { query(state, maze_case(state, 0), 20); }
void BM_QueryPerfectByPortals(benchmark::State& state) { query(state, maze_case(state, 0), 20, 0, false); }

void BM_QueryBends(benchmark::State& state) { query(state, maze_case(state, kOpened), 20, 0, true, true); }
void BM_QueryBendsLandmarks(benchmark::State& state) {
  query(state, maze_case(state, kOpened), 20, kLandmarks, true, true);
}
void BM_QueryLandmarks(benchmark::State& state) { query(state, maze_case(state, kOpened), 20, kLandmarks); }

/// The mesh between the ends, and the query.
void first(benchmark::State& state, double opened) {
  const Case& on = maze_case(state, opened);
  const Pair& pair = on.pairs[0];
  for (auto _ : state) benchmark::DoNotOptimize(shortest_path(on.space, pair.from, pair.to));
}
void graph_first(benchmark::State& state, double opened) {
  const Case& on = maze_case(state, opened);
  const Pair& pair = on.pairs[0];
  const auto expected = shortest_path(on.space, pair.from, pair.to);
  for (auto _ : state)
    if (shortest_path(VisibilityGraph(on.space), pair.from, {pair.to, {}}).path.length != expected->length)
      return state.SkipWithError("the lengths do not agree");
}
void BM_First(benchmark::State& state) { first(state, kOpened); }
void BM_FirstPerfect(benchmark::State& state) { first(state, 0); }
void BM_GraphFirst(benchmark::State& state) { graph_first(state, kOpened); }
void BM_GraphFirstPerfect(benchmark::State& state) { graph_first(state, 0); }

/// Of the other searches: what they find is no shorter, and as long where it is exact.
template <typename Search>
void peer_query(benchmark::State& state, const Case& on, bool exact, Search&& search) {
  PolyanyaSearch mine{Polyanya(on.space)};
  for (std::size_t i = 0; i < 20; ++i) {
    const Pair& pair = on.pairs[i];
    mine.find(pair.from, pair.to);
    const GraphSearchResult found = search(pair);
    const auto order = found.path.length <=> mine.result().path.length;
    if (order < 0 || (exact && order != 0)) return state.SkipWithError("the lengths do not agree");
  }
  std::size_t i = 0, expanded = 0, queries = 0;
  for (auto _ : state) {
    expanded += search(on.pairs[i]).expanded;
    ++queries;
    i = i + 1 == on.pairs.size() ? 0 : i + 1;
  }
  count(state, on, expanded, queries);
}

void BM_GraphQuery(benchmark::State& state) {
  const Case& on = maze_case(state, kOpened);
  const VisibilityGraph graph(on.space);
  peer_query(state, on, true, [&](const Pair& p) { return shortest_path(graph, p.from, {p.to, {}}); });
}
void BM_CellsQuery(benchmark::State& state) {
  const Case& on = maze_case(state, kOpened);
  const CellGraph graph(on.space, CellNeighbours::four);
  peer_query(state, on, false, [&](const Pair& p) { return cell_search(graph, p.from, {p.to, {}}); });
}

// ---- grid maps of others --------------------------------------------------------------------------------------------

const char* const kMaps[] = {"arena", "brc202d", "maze512-32-0", "maze512-8-0", "maze512-8-0-braid20"};

Case map_case(const std::string& name) {
  const std::filesystem::path file = bench::shared_data("movingai") / name;
  Case made{FreeSpace(read_world_file(file.string() + ".map.gz", {})), {}};
  std::ifstream queries(file.string() + ".queries");
  std::string line;
  for (int number = 1; std::getline(queries, line); ++number)
    if (const auto q = query_line(line, file.string(), number))
      made.pairs.push_back({q->from, q->to, q->expected.value_or(-1)});
  return made;
}

void register_maps() {
  if (bench::shared_data("movingai").empty()) return;
  for (const std::string name : kMaps) {
    const auto on = [name] {
      static std::map<std::string, std::shared_ptr<const Case>> cases;
      auto& made = cases[name];
      if (!made) made = std::make_shared<const Case>(map_case(name));
      return made;
    };
    benchmark::RegisterBenchmark(("BM_Query/" + name).c_str(), [on](benchmark::State& state) {
      query(state, *on(), 20);
    })->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("BM_QueryByPortals/" + name).c_str(), [on](benchmark::State& state) {
      query(state, *on(), 20, 0, false);
    })->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("BM_QueryLandmarks/" + name).c_str(), [on](benchmark::State& state) {
      query(state, *on(), 20, kLandmarks);
    })->Unit(benchmark::kMicrosecond);
    for (const std::size_t landmarks : {std::size_t{0}, kLandmarks})
      benchmark::RegisterBenchmark(
          ((landmarks > 0 ? "BM_QueryBendsLandmarks/" : "BM_QueryBends/") + name).c_str(),
          [on, landmarks](benchmark::State& state) { query(state, *on(), 20, landmarks, true, true); })
          ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("BM_Landmarks/" + name).c_str(), [on](benchmark::State& state) {
      const Polyanya plain(on()->space);
      for (auto _ : state) benchmark::DoNotOptimize(plain.with_landmarks(kLandmarks));
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("BM_Mesh/" + name).c_str(), [on](benchmark::State& state) {
      const auto made = on();
      std::size_t polygons = 0;
      for (auto _ : state) polygons = navmesh(made->space).polygon_count();
      state.counters["polygons"] = static_cast<double>(polygons);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("BM_GraphBuild/" + name).c_str(), [on](benchmark::State& state) {
      const auto made = on();
      for (auto _ : state) benchmark::DoNotOptimize(VisibilityGraph(made->space).roadmap().edge_count());
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("BM_GraphQuery/" + name).c_str(), [on](benchmark::State& state) {
      const auto made = on();
      const VisibilityGraph graph(made->space);
      peer_query(state, *made, true, [&](const Pair& p) { return shortest_path(graph, p.from, {p.to, {}}); });
    })->Unit(benchmark::kMicrosecond);
  }
}

[[maybe_unused]] const bool kRegistered = (register_maps(), true);

BENCHMARK(BM_Query)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_QueryLandmarks)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_QueryBends)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_QueryBendsLandmarks)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_QueryPerfect)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_QueryPerfectByPortals)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_GraphQuery)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CellsQuery)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_First)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_FirstPerfect)->Arg(25)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_GraphFirst)->Arg(25)->Arg(61)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_GraphFirstPerfect)->Arg(25)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMicrosecond);

}  // namespace
