#include <fmt/format.h>

#include <cmath>

#include <taut/io/pictures/chase_svg.h>
#include <taut/io/results/words.h>
#include <taut/io/worlds/read_chase_map.h>
#include <taut/io/worlds/read_world.h>
#include <taut/python/bind.h>
#include <taut/robots/pursuit/chase_run.h>

namespace taut::python {

namespace {

using namespace pursuit;

struct Played {
  std::shared_ptr<const ChaseMap> map;
  ChaseRun run;
};

std::shared_ptr<const ChaseMap> map_of(const std::string& bytes, const std::string& source) {
  const py::gil_scoped_release unlocked;
  return about(source, [&] { return std::make_shared<const ChaseMap>(read_chase_map(bytes, source)); });
}

py::array cells_array(const ChaseMap& map, const std::vector<CellIndex>& cells) {
  std::vector<std::int32_t> rows;
  for (const CellIndex i : cells) rows.insert(rows.end(), {map.cell(i).x, map.cell(i).y});
  return moved(std::move(rows), {static_cast<py::ssize_t>(cells.size()), 2});
}

py::array costs_array(const ChaseMap& map) {
  std::vector<double> costs;
  for (int x = 1; x <= map.x_size(); ++x)
    for (int y = 1; y <= map.y_size(); ++y) {
      const CellIndex i = map.index({x, y});
      costs.push_back(map.is_free(i) ? map.cost_value(map.cost(i)) : INFINITY);
    }
  return moved(std::move(costs), {map.x_size(), map.y_size()});
}

Clock clock_named(const std::string& word) {
  if (word != "zero" && word != "one") throw py::value_error("clock: 'zero' or 'one'");
  return word == "zero" ? Clock::zero : Clock::one;
}

Played planned(const std::shared_ptr<const ChaseMap>& map, const std::string& word, const std::string& clock,
               std::optional<int> horizon) {
  ChaseRequest request;
  request.planner = chase_planner(word);
  request.clock = clock_named(clock);
  request.free_planning = true;
  if (!request.planner) throw py::value_error("planner: 'exact', 'entry', 'weighted', 'first' or what may be called");
  if (horizon && *horizon < 0) throw py::value_error("horizon: 0 seconds or more");
  request.horizon = horizon;
  const py::gil_scoped_release unlocked;
  return {map, run_chase(*map, request)};
}

std::pair<int, int> cell_of(const py::object& answer) {
  try {
    return answer.cast<std::pair<int, int>>();
  } catch (const py::cast_error&) {
    throw py::type_error("a planner gives the next cell (x, y), or None, not " + std::string(py::repr(answer)));
  }
}

// `robot(cell, second)` gives the next cell, or None.
Played driven(const std::shared_ptr<const ChaseMap>& map, const py::object& robot, const std::string& clock) {
  Played played;
  played.map = map;
  played.run.request.clock = clock_named(clock);
  played.run.request.free_planning = true;
  const auto next = [&](CellIndex at, int now) -> std::optional<CellIndex> {
    const py::object answer = robot(py::make_tuple(map->cell(at).x, map->cell(at).y), now);
    if (answer.is_none()) return std::nullopt;
    const std::pair<int, int> cell = cell_of(answer);
    const bool on_map =
        cell.first >= 0 && cell.second >= 0 && cell.first <= map->x_size() + 1 && cell.second <= map->y_size() + 1;
    return map->index(on_map ? Cell{cell.first, cell.second} : Cell{0, 0});  // the border is an obstacle
  };
  played.run.result = play(*map, {.clock = played.run.request.clock, .free_planning = true}, next);
  return played;
}

Played chase(const std::shared_ptr<const ChaseMap>& map, const py::object& planner, const std::string& clock,
             std::optional<int> horizon) {
  if (py::isinstance<py::str>(planner)) return planned(map, planner.cast<std::string>(), clock, horizon);
  if (!PyCallable_Check(planner.ptr())) throw py::type_error("planner: a name, or what may be called");
  return driven(map, planner, clock);
}

py::array track_of(const Played& p) {
  std::vector<std::int32_t> rows;
  for (const ChaseStep& step : p.run.result.track) {
    const Cell cell = p.map->cell(step.cell);
    rows.insert(rows.end(), {cell.x, cell.y, step.second});
  }
  return moved(std::move(rows), {static_cast<py::ssize_t>(p.run.result.track.size()), 3});
}

const char* words(ChaseEnd end) {
  static constexpr const char* kNames[] = {"caught", "escaped", "gave up", "illegal"};
  return kNames[static_cast<int>(end)];
}

void bind_maps(py::module_& m) {
  py::class_<ChaseMap, std::shared_ptr<ChaseMap>>(m, "ChaseMap", "A cost map, a robot's start, a target's trajectory.")
      .def_property_readonly("costs", &costs_array, "(x, y): of cell (1, 1) at [0, 0]; inf in obstacles.")
      .def_property_readonly(
          "target", [](const ChaseMap& map) { return cells_array(map, map.target()); }, "(n, 2): x, y, one a second.")
      .def_property_readonly("start", [](const ChaseMap& map) {
        const Cell cell = map.cell(map.start());
        return py::make_tuple(cell.x, cell.y);
      });
  m.def(
      "read_chase_map",
      [](const std::string& text, const std::string& source) {
        return std::const_pointer_cast<ChaseMap>(map_of(text, source));
      },
      py::arg("text"), py::arg("source") = "", "A ChaseMap of a text with sections N, C, R, T, M. Raises InputError.");
  m.def(
      "read_chase_map_file",
      [](const py::object& path) {
        const auto name = py::module_::import("os").attr("fspath")(path).cast<std::string>();
        return std::const_pointer_cast<ChaseMap>(map_of(about(name, [&] { return read_bytes(name); }), name));
      },
      py::arg("path"), "The same from a file.");
}

}  // namespace

void bind_chases(py::module_& m) {
  bind_maps(m);
  py::class_<Played>(m, "ChaseRun", "How a chase went.")
      .def_property_readonly("caught", [](const Played& p) { return p.run.is_caught(); })
      .def_property_readonly(
          "end", [](const Played& p) { return words(p.run.result.end); }, "'caught', 'escaped', 'gave up', 'illegal'.")
      .def_property_readonly("reason",
                             [](const Played& p) {
                               return p.run.result.reason.empty() && !p.run.is_caught() ? p.run.plan.reason
                                                                                        : p.run.result.reason;
                             })
      .def_property_readonly("cost", [](const Played& p) { return p.map->cost_value(p.run.result.cost); })
      .def_property_readonly(
          "seconds", [](const Played& p) { return p.run.result.time; }, "That passed.")
      .def_property_readonly(
          "moves", [](const Played& p) { return p.run.result.moves; }, "Waiting is none.")
      .def_property_readonly(
          "optimal", [](const Played& p) { return p.run.is_proven(*p.map); }, "Nobody catches it for less, proven.")
      .def_property_readonly("track", &track_of, "(n, 3) int32: x, y, second.")
      .def("__bool__", [](const Played& p) { return p.run.is_caught(); })
      .def(
          "_repr_svg_", [](const Played& p) { return chase_svg(*p.map, p.run, title_of(p.map->source()), false); },
          Unlocked())
      .def("__repr__", [](const Played& p) {
        return fmt::format("<taut.ChaseRun {}, cost {}, {} s>", words(p.run.result.end),
                           p.map->cost_text(p.run.result.cost), p.run.result.time);
      });
  m.def(
      "chase", &chase, py::arg("map").none(false), py::arg("planner") = "exact", py::kw_only(),
      py::arg("clock") = "zero", py::arg("horizon") = py::none(),
      "A ChaseRun by 'exact', 'entry', 'weighted', 'first', or by what may be called: planner((x, y), second) gives "
      "the next cell, itself to wait, None to give up. horizon: seconds of the trajectory that are seen ahead. A step "
      "takes one second.");
}

}  // namespace taut::python
