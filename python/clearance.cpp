#include <fmt/format.h>

#include <taut/geometry/walled_world.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/words.h>
#include <taut/python/answers.h>
#include <taut/search/clearance_planner.h>
#include <taut/search/query_ends.h>
#include <taut/search/voronoi_search.h>

namespace taut::python {

namespace {

/// A way along the Voronoi diagram.
struct ClearWay {
  FreeSpace space;
  Point start, goal;
  ClearancePath path;
  std::vector<Point> points;
};

using Kind = ClearanceQuery::Kind;

std::vector<ClearWay> ways(const World& world, const std::optional<Point>& start, const Goal& goal,
                           const ClearanceQuery& query) {
  const Point from = start_of(world, start);
  const Goal to = goal_of_query(world, goal);
  const py::gil_scoped_release unlocked;
  const FreeSpace space = about(world.source(), [&] { return FreeSpace(world); });
  require_ends(space, from, to);
  std::vector<Point> ends = goal_points(space, to);
  if (ends.empty()) throw Refusal(InputError("", 0, "the middles of the goal room are no free places"), "");
  const std::vector<Point> goals = ends;
  ends.push_back(from);
  const FreeSpace walled(walled_world(world, ends));
  const ClearancePlanner planner(space, VoronoiRoadmap(walled), Gates(walled), from, goals);
  ClearanceAnswer answer = planner.answer(query);
  if (answer.status == SearchStatus::found) planner.verify(answer);
  if (answer.status == SearchStatus::stopped) throw Unproven(clearance_reason(answer, planner.gates()));
  std::vector<ClearWay> found;
  if (answer.status == SearchStatus::found)
    for (const ClearanceTrade& trade : answer.found)
      found.push_back({walled, answer.start, answer.goal, trade.path, planner.points_of(trade.path)});
  return found;
}

std::optional<ClearWay> first(std::vector<ClearWay> found) {
  if (found.empty()) return std::nullopt;
  return std::move(found.front());
}

std::optional<ClearWay> clear(const World& world, double clearance, const std::optional<Point>& start,
                              const Goal& goal) {
  if (!(clearance >= 0 && clearance <= World::kLargest)) throw py::value_error("clearance: 0 or more");
  return first(ways(world, start, goal, {Kind::at_least, clearance}));
}

std::string picture(const ClearWay& way) {
  return svg(way.space, {.title = title_of(way.space.world().source()),
                         .facts = {"length " + plain_length(way.path.length),
                                   "clearance " + number_text(way.path.pinch.clearance)},
                         .start = way.start,
                         .goal = Goal{way.goal, {}},
                         .curves = way.path.curves});
}

}  // namespace

void bind_clearance(py::module_& m) {
  py::class_<ClearWay>(m, "ClearPath", "A path in the middle between walls, along the Voronoi diagram.")
      .def_property_readonly(
          "length", [](const ClearWay& w) { return w.path.length; }, "To about 1e-13 of itself.")
      .def_property_readonly(
          "clearance", [](const ClearWay& w) { return w.path.pinch.clearance; }, "The least distance to a wall.")
      .def_property_readonly(
          "points", [](const py::object& self) { return points_view(self.cast<const ClearWay&>().points, self); },
          "(n, 2): legs between them are no farther from it than 1/10 000 of a corridor.")
      .def_property_readonly(
          "narrowest", [](const ClearWay& w) { return place_text(w.path.pinch); }, "Where that is, in words.")
      .def_readonly("start", &ClearWay::start)
      .def_readonly("goal", &ClearWay::goal)
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", [](const ClearWay& w) {
        return fmt::format("<taut.ClearPath length {}, clearance {}>", plain_length(w.path.length),
                           number_text(w.path.pinch.clearance));
      });
  m.def("clear_path", &clear, py::arg("world"), py::arg("clearance"), py::arg("start") = py::none(),
        py::arg("goal") = py::none(),
        "The shortest ClearPath, along the Voronoi diagram, that keeps the clearance; None when none does, proven. "
        "Raises InputError, Unproven.");
  m.def(
      "widest_path",
      [](const World& world, const std::optional<Point>& start, const Goal& goal) {
        return first(ways(world, start, goal, {Kind::widest, 0}));
      },
      py::arg("world"), py::arg("start") = py::none(), py::arg("goal") = py::none(),
      "The ClearPath with the largest clearance; None when there is no path, proven.");
  m.def(
      "clearance_tradeoff",
      [](const World& world, const std::optional<Point>& start, const Goal& goal) {
        return ways(world, start, goal, {Kind::tradeoff, 0});
      },
      py::arg("world"), py::arg("start") = py::none(), py::arg("goal") = py::none(),
      "Every best ClearPath, from the shortest to the widest: what room costs in length.");
}

}  // namespace taut::python
