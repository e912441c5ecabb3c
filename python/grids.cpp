#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include <taut/geometry/occupancy_world.h>
#include <taut/io/pictures/grid_svg.h>
#include <taut/io/worlds/ros_map.h>
#include <taut/python/bind.h>
#include <taut/search/grid/grid_search.h>

namespace taut::python {

namespace {

using Cells = py::array_t<bool, py::array::c_style | py::array::forcecast>;

OccupancyGrid grid_of(const py::object& given) {
  const Cells cells = Cells::ensure(given);
  if (!cells || cells.ndim() != 2 || cells.size() == 0) {
    PyErr_Clear();
    throw py::value_error("blocked: an array (rows, columns) of free and blocked cells");
  }
  OccupancyGrid grid{static_cast<std::uint32_t>(cells.shape(1)), static_cast<std::uint32_t>(cells.shape(0)), {}};
  grid.blocked.assign(cells.data(), cells.data() + cells.size());
  return grid;
}

World world_of_grid(const py::object& blocked, std::optional<double> resolution, Point origin, double yaw,
                    const std::string& source) {
  const OccupancyGrid grid = grid_of(blocked);
  const bool placed =
      is_in_reach(origin) && std::isfinite(yaw) && (!resolution || (*resolution > 0 && *resolution <= World::kLargest));
  if (!placed) throw py::value_error("resolution: above 0; origin and yaw: finite");
  const py::gil_scoped_release unlocked;
  return about(source, [&] {
    if (!resolution) return world_of(grid, source);
    RosMapInfo info;
    info.resolution = *resolution;
    info.origin = origin;
    info.yaw = yaw;
    return ros_world(grid, info, source);
  });
}

GridMoves moves_of(const py::object& word) {
  const auto moves = grid_moves_named(py::str(word).cast<std::string>());
  if (!moves) throw py::value_error("moves: 4, 8 or 'octile', not " + std::string(py::repr(word)));
  return *moves;
}

GridPlace place_of(const py::object& cell) {
  const auto at = point_of(cell);
  const auto fits = [](double v) { return v >= 0 && v <= 4e9 && v == std::floor(v); };
  if (!at || !fits(at->x) || !fits(at->y)) throw py::type_error("a cell is a pair of whole numbers: row, column");
  return {static_cast<std::uint32_t>(at->x), static_cast<std::uint32_t>(at->y)};
}

py::array places_array(const std::vector<GridPlace>& places) {
  std::vector<std::uint32_t> cells;
  cells.reserve(2 * places.size());
  for (const GridPlace& p : places) cells.insert(cells.end(), {p.row, p.column});
  return moved(std::move(cells), {static_cast<py::ssize_t>(places.size()), 2});
}

/// A grid and its searches, one at a time.
class Grid {
 public:
  Grid(OccupancyGrid grid, GridMoves moves) : grid_(std::move(grid)), search_(grid_, moves), moves_(moves) {}

  GridResult find(GridPlace start, GridPlace goal, const GridQuery& query) {
    const std::scoped_lock lock(mutex_);
    return search_.find(start, goal, query);
  }
  std::vector<std::optional<GridCost>> costs_to(GridPlace goal) {
    const std::scoped_lock lock(mutex_);
    return search_.costs_to(goal);
  }
  const OccupancyGrid& cells() const { return grid_; }
  GridMoves moves() const { return moves_; }

 private:
  OccupancyGrid grid_;
  GridSearch search_;
  GridMoves moves_;
  std::mutex mutex_;
};

struct GridAnswer {
  std::shared_ptr<Grid> grid;
  GridPlace start, goal;
  GridResult result;
};

GridAnswer find(const std::shared_ptr<Grid>& grid, const py::object& start, const py::object& goal,
                const std::string& algorithm, const py::object& heuristic, const std::string& ties, double weight,
                bool record) {
  GridQuery query;
  const auto how = grid_algorithm_named(algorithm);
  if (!how) throw py::value_error("algorithm: there is no '" + algorithm + "'");
  query.algorithm = *how;
  query.heuristic = natural_heuristic(grid->moves());
  if (!heuristic.is_none()) {
    const auto estimate = grid_heuristic_named(heuristic.cast<std::string>());
    if (!estimate) throw py::value_error("heuristic: " + grid_estimate_names() + ", joined by commas");
    query.heuristic = *estimate;
  }
  if (ties != "fifo" && ties != "lifo") throw py::value_error("ties: 'fifo' or 'lifo'");
  if (!(weight >= 1 && weight <= 1000)) throw py::value_error("weight: 1 to 1000");
  query.ties = ties == "fifo" ? Ties::fifo : Ties::lifo;
  query.weight = static_cast<std::uint32_t>(std::lround(weight * 1000));
  query.record = record;
  const GridPlace from = place_of(start), to = place_of(goal);
  const py::gil_scoped_release unlocked;
  return {grid, from, to, grid->find(from, to, query)};
}

// The moves in the order in which neighbours are looked at: row and column differences.
constexpr std::array<std::array<int, 2>, 8> kMoves{
    {{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1}}};

bool is_open(const Grid& grid, std::int64_t row, std::int64_t column, std::size_t move) {
  const auto [down, right] = kMoves[move];
  if (!grid.cells().free(column + right, row + down)) return false;
  return move < 4 || grid.moves() != GridMoves::octile ||
         (grid.cells().free(column + right, row) && grid.cells().free(column, row + down));
}

// Of each cell the first move of a cheapest way, as an index of kMoves; -1 at the goal and where there is none.
std::vector<std::int8_t> first_moves(const Grid& grid, const std::vector<std::optional<GridCost>>& costs) {
  const std::int64_t width = grid.cells().width, height = grid.cells().height;
  const std::size_t count = grid.moves() == GridMoves::four ? 4 : 8;
  std::vector<std::int8_t> moves(costs.size(), -1);
  for (std::int64_t row = 0, i = 0; row < height; ++row)
    for (std::int64_t column = 0; column < width; ++column, ++i)
      for (std::size_t m = 0; m < count && moves[i] < 0; ++m) {
        if (!costs[i] || !is_open(grid, row, column, m)) continue;
        const auto& next = costs[i + kMoves[m][0] * width + kMoves[m][1]];
        if (next && *next + (m < 4 ? GridCost(1, 0) : GridCost(0, 1)) == *costs[i])
          moves[i] = static_cast<std::int8_t>(m);
      }
  return moves;
}

py::tuple distances_to(Grid& grid, const py::object& goal) {
  const GridPlace to = place_of(goal);
  std::vector<double> lengths;
  std::vector<std::int8_t> moves;
  {
    const py::gil_scoped_release unlocked;
    const auto costs = grid.costs_to(to);
    moves = first_moves(grid, costs);
    lengths.reserve(costs.size());
    for (const auto& cost : costs) lengths.push_back(cost ? cost->value() : std::numeric_limits<double>::infinity());
  }
  const std::vector<py::ssize_t> shape{grid.cells().height, grid.cells().width};
  return py::make_tuple(moved(std::move(lengths), shape), moved(std::move(moves), shape));
}

std::string picture(const GridAnswer& a) {
  GridPicture shown;
  shown.visited = a.result.visited;
  shown.frontier = a.result.frontier;
  shown.path = a.result.path;
  shown.start = a.start;
  shown.goal = a.goal;
  return grid_svg(a.grid->cells(), shown);
}

void bind_answer(py::module_& m) {
  py::class_<GridAnswer>(m, "GridAnswer", "What a search on a grid found, and what it took.")
      .def_property_readonly("found", [](const GridAnswer& a) { return a.result.status == SearchStatus::found; })
      .def_property_readonly(
          "path", [](const GridAnswer& a) { return places_array(a.result.path); },
          "(n, 2): row, column from start to goal; empty unless found.")
      .def_property_readonly(
          "cost", [](const GridAnswer& a) { return a.result.cost.value(); },
          "Straight moves are 1, diagonal ones sqrt(2).")
      .def_property_readonly(
          "moves",
          [](const GridAnswer& a) { return py::make_tuple(a.result.cost.straight(), a.result.cost.diagonal()); },
          "How many straight, how many diagonal moves the cost is.")
      .def_property_readonly(
          "optimal", [](const GridAnswer& a) { return a.result.optimal; }, "Proven.")
      .def_property_readonly(
          "steps", [](const GridAnswer& a) { return a.result.steps; }, "Cells taken.")
      .def_property_readonly(
          "entered", [](const GridAnswer& a) { return a.result.entered; }, "Entries of the frontier.")
      .def_property_readonly(
          "visited", [](const GridAnswer& a) { return places_array(a.result.visited); },
          "(n, 2): cells in the order of their first taking, where recorded.")
      .def_property_readonly("frontier", [](const GridAnswer& a) { return places_array(a.result.frontier); })
      .def("__bool__", [](const GridAnswer& a) { return a.result.status == SearchStatus::found; })
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", [](const GridAnswer& a) {
        return a.result.status == SearchStatus::found
                   ? fmt::format("<taut.GridAnswer cost {}, {} steps>", a.result.cost.value(), a.result.steps)
                   : fmt::format("<taut.GridAnswer none, {} steps>", a.result.steps);
      });
}

}  // namespace

void bind_grids(py::module_& m) {
  bind_answer(m);
  py::class_<Grid, std::shared_ptr<Grid>>(
      m, "Grid", "A grid of cells (rows, columns), row 0 on top, true where blocked, and searches on it.")
      .def(py::init([](const py::object& blocked, const py::object& moves) {
             return std::make_shared<Grid>(grid_of(blocked), moves_of(moves));
           }),
           py::arg("blocked"), py::arg("moves") = 4,
           "moves: 4, 8, or 'octile': diagonal ones only where both cells beside them are free.")
      .def("find", &find, py::arg("start"), py::arg("goal"), py::arg("algorithm") = "astar",
           py::arg("heuristic") = py::none(), py::kw_only(), py::arg("ties") = "fifo", py::arg("weight") = 1.5,
           py::arg("record") = false,
           "A GridAnswer from start to goal (row, column), by 'bfs', 'dfs', 'dijkstra', 'greedy', 'greedy-once', "
           "'astar', 'weighted-astar', 'bidirectional-astar', 'idastar', 'jps'. record: keep what was visited. Raises "
           "InputError when an end is blocked.")
      .def("distances_to", &distances_to, py::arg("goal"),
           "length (rows, columns): of the cheapest way from each cell to the goal, inf where there is none; move "
           "(rows, "
           "columns) int8: its first move, an index of GRID_MOVES, -1 at the goal and where there is no way. Exact.");
  m.def(
      "occupancy_world", &world_of_grid, py::arg("blocked"), py::kw_only(), py::arg("resolution") = py::none(),
      py::arg("origin") = Point{}, py::arg("yaw") = 0.0, py::arg("source") = "",
      "The World of cells (rows, columns), row 0 on top: cell (row r, column c) is [c, c + 1] x [r, r + 1], y down. "
      "With a resolution in metres a cell, y up, the lower left corner at origin, turned by yaw around it, as ROS has "
      "maps.");
  py::list moves;
  for (const auto& [down, right] : kMoves) moves.append(py::make_tuple(down, right));
  m.attr("GRID_MOVES") = py::tuple(moves);
}

}  // namespace taut::python
