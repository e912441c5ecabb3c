// Searches on one grid side by side, with Boost.Graph's A* and Dijkstra on the same grid as peers. Every answer is
// checked: exact costs must be equal, the peers' doubles must agree to rounding, and each path is replayed.
#include <benchmark/benchmark.h>

#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <taut/search/grid/grid_generator.h>
#include <taut/search/grid/grid_search.h>

namespace {

using taut::GridAlgorithm;
using taut::GridKind;
using taut::GridMoves;
using taut::GridPlace;
using taut::OccupancyGrid;

constexpr std::uint32_t kSide = 512;

/// A map and the free cells nearest to two of its corners.
struct Task {
  OccupancyGrid grid;
  GridPlace start, goal;
};

/// The first and the last cell, by rows, from which a quarter of the free cells can be reached, so that a path joins
/// them.
Task task_of(GridKind kind) {
  Task task{taut::generate_grid(kind, kSide, kSide, 1), {}, {}};
  taut::GridSearch search(task.grid, GridMoves::octile);
  const auto free_cells = static_cast<std::size_t>(std::count(task.grid.blocked.begin(), task.grid.blocked.end(), 0));
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    task.start = {i / kSide, i % kSide};
    if (!task.grid.free(task.start.column, task.start.row)) continue;
    const auto costs = search.costs_to(task.start);
    const auto reached =
        static_cast<std::size_t>(std::count_if(costs.begin(), costs.end(), [](auto& c) { return c.has_value(); }));
    if (4 * reached < free_cells) continue;
    for (std::uint32_t last = kSide * kSide; last-- > 0;)
      if (costs[last]) {
        task.goal = {last / kSide, last % kSide};
        return task;
      }
  }
  std::abort();
}

const Task& task(GridKind kind) {
  static const Task tasks[] = {task_of(GridKind::maze), task_of(GridKind::rooms), task_of(GridKind::random)};
  return tasks[static_cast<std::size_t>(kind)];
}

taut::GridCost least_cost(GridKind kind) {
  const Task& t = task(kind);
  return taut::GridSearch(t.grid, GridMoves::octile).find(t.start, t.goal, {GridAlgorithm::dijkstra, {}}).cost;
}

void search(benchmark::State& state, GridKind kind, GridAlgorithm algorithm) {
  const Task& t = task(kind);
  taut::GridSearch engine(t.grid, GridMoves::octile);
  const taut::GridQuery query{algorithm, taut::natural_heuristic(GridMoves::octile)};
  taut::GridResult result;
  for (auto _ : state) result = engine.find(t.start, t.goal, query);
  const taut::GridPathVerdict check = verify_grid_path(t.grid, GridMoves::octile, t.start, t.goal, result.path);
  const taut::GridCost least = least_cost(kind);
  if (!check.fault.empty() || check.cost != result.cost || result.cost < least ||
      (result.optimal && result.cost != least))
    state.SkipWithError("wrong answer");
  state.counters["steps"] = static_cast<double>(result.steps);
  state.counters["ratio"] = result.cost.value() / least.value();
}

using Vertex = std::uint32_t;
using Csr = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property,
                                               boost::property<boost::edge_weight_t, double>, boost::no_property,
                                               Vertex, std::uint32_t>;

Csr graph_of(const OccupancyGrid& grid) {
  std::vector<std::pair<Vertex, Vertex>> edges;
  std::vector<double> weights;
  const auto side = static_cast<std::int64_t>(kSide);
  for (std::int64_t r = 0; r < side; ++r)
    for (std::int64_t c = 0; c < side; ++c)
      for (std::int64_t dr = -1; dr <= 1; ++dr)
        for (std::int64_t dc = -1; dc <= 1; ++dc) {
          if ((dr == 0 && dc == 0) || !grid.free(c, r) || !grid.free(c + dc, r + dr)) continue;
          if (dr != 0 && dc != 0 && !(grid.free(c + dc, r) && grid.free(c, r + dr))) continue;
          edges.emplace_back(static_cast<Vertex>(r * side + c), static_cast<Vertex>((r + dr) * side + c + dc));
          weights.push_back(dr != 0 && dc != 0 ? std::sqrt(2.0) : 1.0);
        }
  return Csr(boost::edges_are_sorted, edges.begin(), edges.end(), weights.begin(), kSide * kSide);
}

struct Found {};

struct Octile {
  GridPlace goal;
  double operator()(Vertex v) const {
    const double dr = std::abs(static_cast<double>(v / kSide) - goal.row);
    const double dc = std::abs(static_cast<double>(v % kSide) - goal.column);
    return std::max(dr, dc) + (std::sqrt(2.0) - 1) * std::min(dr, dc);
  }
};

struct StopAtGoal : boost::default_astar_visitor {
  Vertex goal;
  std::size_t* steps;
  StopAtGoal(Vertex at, std::size_t* count) : goal(at), steps(count) {}
  void examine_vertex(Vertex v, const Csr&) const {
    ++*steps;
    if (v == goal) throw Found{};
  }
};

/// The peer's graph is built beforehand and counted for nobody; its maps are filled for each query, as its users have
/// to.
void boost_astar(benchmark::State& state, GridKind kind) {
  const Task& t = task(kind);
  const Csr graph = graph_of(t.grid);
  const auto index = get(boost::vertex_index, graph);
  const Vertex from = t.start.row * kSide + t.start.column, to = t.goal.row * kSide + t.goal.column;
  std::size_t steps = 0;
  double cost = 0;
  for (auto _ : state) {
    steps = 0;
    std::vector<Vertex> predecessor(kSide * kSide);
    std::vector<double> distance(kSide * kSide);
    try {
      boost::astar_search(graph, from, Octile{t.goal},
                          boost::visitor(StopAtGoal(to, &steps))
                              .predecessor_map(boost::make_iterator_property_map(predecessor.begin(), index))
                              .distance_map(boost::make_iterator_property_map(distance.begin(), index)));
    } catch (Found) {
    }
    cost = distance[to];
  }
  if (std::abs(cost - least_cost(kind).value()) > 1e-6) state.SkipWithError("wrong answer");
  state.counters["steps"] = static_cast<double>(steps);
}

void add_all() {
  for (const GridKind kind : {GridKind::maze, GridKind::rooms, GridKind::random}) {
    const std::string map(name(kind));
    for (const GridAlgorithm a :
         {GridAlgorithm::bfs, GridAlgorithm::dfs, GridAlgorithm::dijkstra, GridAlgorithm::greedy_once,
          GridAlgorithm::astar, GridAlgorithm::weighted_astar, GridAlgorithm::bidirectional_astar, GridAlgorithm::jps})
      benchmark::RegisterBenchmark((map + "/" + std::string(name(a))).c_str(), search, kind, a)
          ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark((map + "/boost-astar").c_str(), boost_astar, kind)->Unit(benchmark::kMicrosecond);
  }
}

[[maybe_unused]] const bool kAdded = (add_all(), true);

}  // namespace
