#include <fmt/format.h>

#include <taut/geometry/rounding.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>
#include <taut/python/answers.h>
#include <taut/search/corner_count.h>
#include <taut/search/no_path.h>
#include <taut/search/query_ends.h>
#include <taut/search/verify.h>

namespace taut::python {

namespace {

Verdict verdict_of(const FoundPath& found) { return verify(found.path, found.space, found.from, found.to); }

std::size_t corners_of(const FoundPath& found) {
  return corner_count(found.path.points, found.space.world().uncertainty());
}

std::string picture(const FoundPath& found) {
  const std::string length = "length " + length_text(found.path.length);
  return svg(found.space, {.title = title_of(found.space.world().source()),
                           .facts = {length, count_text(corners_of(found), "corner")},
                           .path = &found.path,
                           .start = found.from,
                           .goal = found.to});
}

std::string picture_of_none(const Apart& none) {
  return svg(none.space, {.title = title_of(none.space.world().source()),
                          .facts = {"no path"},
                          .separation = none.walls,
                          .start = none.from,
                          .goal = none.to});
}

void bind_verdict(py::module_& m) {
  py::class_<Verdict>(m, "Verdict", "What the check of a path found that shares nothing with the planners.")
      .def_readonly("valid", &Verdict::valid)
      .def_readonly("reason", &Verdict::reason, "Empty when valid, else one line.")
      .def_readonly("leg", &Verdict::leg, "The first offending leg, from 0.")
      .def_readonly("clearance", &Verdict::clearance)
      .def("__bool__", [](const Verdict& v) { return v.valid; })
      .def("__repr__", [](const Verdict& v) {
        return v.valid ? std::string("<taut.Verdict valid>") : "<taut.Verdict: " + v.reason + ">";
      });
}

Verdict checked(const FreeSpace& space, const py::object& given, const std::optional<Point>& start, const Goal& goal) {
  Path path;
  path.points = points_of(given, "points");
  if (path.points.empty()) throw py::value_error("points: there is none");
  for (const Point p : path.points)
    if (!is_in_reach(p)) throw InputError("", 0, "points: not all are points");
  const py::gil_scoped_release unlocked;
  path.length = Length(path.points);
  const Goal to = goal.point || !goal.room.empty() ? goal : Goal{path.points.back(), {}};
  return verify(path, space, start.value_or(path.points.front()), to);
}

}  // namespace

Point start_of(const World& world, const std::optional<Point>& given) {
  if (given) return *given;
  if (!world.start()) throw Refusal(InputError(world.source(), 0, "says nothing about a start"), world.source());
  return *world.start();
}

Goal goal_of_query(const World& world, const Goal& given) {
  const Goal& goal = given.point || !given.room.empty() ? given : world.goal();
  if (!goal.point && goal.room.empty())
    throw Refusal(InputError(world.source(), 0, "says nothing about a goal"), world.source());
  return goal;
}

void require_ends(const FreeSpace& space, Point from, const Goal& to) {
  about(space.world().source(), [&] {
    require_free(space, from, "start");
    if (to.point) require_free(space, *to.point, "goal");
  });
}

double within_of(const FreeSpace& space) {
  return space.footprint().kind() == Footprint::Kind::disc ? 0 : rounding_bound(space);
}

std::optional<Apart> apart(const FreeSpace& space, Point from, const Goal& to) {
  require_ends(space, from, to);
  const auto walls = NoPath(space).walls(from, to);
  if (!walls) return std::nullopt;
  Apart none{space, from, to, {}};
  for (const Constraint& piece : *walls) none.walls.push_back({piece.a, piece.b});
  return none;
}

std::string unproven_text(const FreeSpace& space) {
  if (space.footprint().kind() == Footprint::Kind::disc)
    return "no path for the polygon around the disc, which does not prove that there is none for the disc";
  return fmt::format(
      "no path, but an end is so near a wall ({:.3g}) that rounded crossings may have put it on its "
      "other side",
      rounding_bound(space));
}

void bind_paths(py::module_& m) {
  bind_verdict(m);
  py::class_<FoundPath>(m, "Path", "A path of the robot's reference point.")
      .def_property_readonly(
          "points", [](const py::object& self) { return points_view(self.cast<const FoundPath&>().path.points, self); },
          "(n, 2): from start to goal.")
      .def_property_readonly(
          "length", [](const FoundPath& f) { return f.path.length.value(); }, "To the nearest double.")
      .def_property_readonly(
          "exact_length", [](const FoundPath& f) { return f.path.length; }, "A Length: compares exactly.")
      .def_readonly("optimal", &FoundPath::optimal, "It is the shortest, proven.")
      .def_readonly("within", &FoundPath::within,
                    "0, or where crossings of walls were rounded: no path that stays so far from obstacles is "
                    "shorter, and this one goes through none deeper.")
      .def_readonly("planner", &FoundPath::planner, "What found it.")
      .def_readonly("expanded", &FoundPath::expanded, "Nodes that the search took from its queue.")
      .def_readonly("start", &FoundPath::from)
      .def_readonly("goal", &FoundPath::to, "A point, or a room as boxes (n, 4).")
      .def_readonly("space", &FoundPath::space)
      .def_property_readonly("corners", &corners_of, "How often it bends.")
      .def_property_readonly(
          "clearance", [](const FoundPath& f) { return verdict_of(f).clearance; }, Unlocked(),
          "The least distance to an obstacle; 0 when it touches one.")
      .def("verify", &verdict_of, Unlocked(), "A check that shares nothing with the planners: a Verdict.")
      .def(
          "decimals", [](const FoundPath& f, int places) { return decimals_of(f.path.length, places); },
          py::arg("places"), "The length with that many decimals, as text.")
      .def("__len__", [](const FoundPath& f) { return f.path.points.size(); })
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", [](const FoundPath& f) {
        return fmt::format("<taut.Path length {}, {}>", length_text(f.path.length),
                           count_text(corners_of(f), "corner"));
      });
  py::class_<Apart>(m, "NoPath", "That there is no path, proven, and why.")
      .def_property_readonly(
          "walls", [](const Apart& a) { return segments_array(a.walls); },
          "(n, 4): the closed chain of walls between the ends, in order.")
      .def_readonly("start", &Apart::from)
      .def_readonly("goal", &Apart::to)
      .def("_repr_svg_", &picture_of_none, Unlocked())
      .def("__repr__", [](const Apart& a) { return "<taut.NoPath: " + segments_text(a.walls, 3) + ">"; });
  m.def("no_path", &apart, Unlocked(), py::arg("space"), py::arg("start"), py::arg("goal"),
        "A NoPath with the walls that separate the ends; None when nothing proves that there is no path. Raises "
        "InputError when an end is not free.");
  m.def("verify", &checked, py::arg("space"), py::arg("points"), py::arg("start") = py::none(),
        py::arg("goal") = py::none(),
        "Can the points (n, 2) be followed, from start to goal? A Verdict, by a check that shares nothing with the "
        "planners. Without ends, from the first to the last point.");
}

}  // namespace taut::python
