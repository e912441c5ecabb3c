#include <fmt/format.h>

#include <array>
#include <cmath>

#include <taut/io/pictures/bug_svg.h>
#include <taut/io/results/words.h>
#include <taut/python/answers.h>
#include <taut/robots/bug/bug.h>

namespace taut::python {

namespace {

using namespace bug;

struct Trip {
  FreeSpace space;
  Point start, goal;
  Options options;
  Journey journey;
};

py::array contacts_array(const std::vector<Contact>& contacts) {
  std::vector<Point> points;
  for (const Contact& contact : contacts) points.push_back(contact.at);
  return points_array(std::move(points));
}

Algorithm algorithm_named(const std::string& word) {
  for (const Algorithm algorithm : {Algorithm::bug1, Algorithm::bug2, Algorithm::tangent})
    if (word == name(algorithm)) return algorithm;
  throw py::value_error("algorithm: 'bug1', 'bug2' or 'tangent', not '" + word + "'");
}

Trip trip(const FreeSpace& space, const std::string& algorithm, const std::optional<Point>& start, const Goal& goal,
          const std::string& turn, double range) {
  Options options{.algorithm = algorithm_named(algorithm)};
  if (turn != "left" && turn != "right") throw py::value_error("turn: 'left' or 'right'");
  if (!(range >= 0)) throw py::value_error("range: 0 or more");
  options.turn = turn == "left" ? Turn::left : Turn::right;
  options.range = range;
  const Point from = start_of(space.world(), start);
  const Goal to = goal_of_query(space.world(), goal);
  if (!to.point) throw InputError("", 0, "the goal of a bug is a point");
  const py::gil_scoped_release unlocked;
  require_ends(space, from, to);
  return {space, from, *to.point, options, travel(space, from, *to.point, options)};
}

std::string text(const Trip& t) {
  return (t.journey.reached ? "length " : "no path, proven; walked ") + length_text(t.journey.path.length);
}

std::string picture(const Trip& t) {
  return bug_svg(t.space, t.journey,
                 {.title = title_of(t.space.world().source()),
                  .facts = {text(t)},
                  .start = t.start,
                  .goal = t.goal,
                  .algorithm = t.options.algorithm});
}

}  // namespace

void bind_bugs(py::module_& m) {
  py::class_<Trip>(m, "Journey", "What a bug walked.")
      .def_property_readonly(
          "reached", [](const Trip& t) { return t.journey.reached; }, "False: there is no path, proven.")
      .def_property_readonly(
          "points",
          [](const py::object& self) { return points_view(self.cast<const Trip&>().journey.path.points, self); },
          "(n, 2): all that was walked.")
      .def_property_readonly("length", [](const Trip& t) { return t.journey.path.length.value(); })
      .def_property_readonly(
          "bound", [](const Trip& t) { return t.journey.bound.hi; }, "What it never walks more than, by its theory.")
      .def_property_readonly(
          "hits", [](const Trip& t) { return contacts_array(t.journey.hits); }, "(n, 2).")
      .def_property_readonly(
          "leaves", [](const Trip& t) { return contacts_array(t.journey.leaves); }, "(n, 2).")
      .def("__bool__", [](const Trip& t) { return t.journey.reached; })
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__",
           [](const Trip& t) { return fmt::format("<taut.Journey of {}: {}>", name(t.options.algorithm), text(t)); });
  m.def(
      "bug", &trip, py::arg("space"), py::arg("algorithm") = "bug2", py::arg("start") = py::none(),
      py::arg("goal") = py::none(), py::kw_only(), py::arg("turn") = "left", py::arg("range") = INFINITY,
      "The Journey of a bug that knows where its goal is, and of walls what it touches ('bug1', 'bug2') or sees as far "
      "as range ('tangent'). Raises InputError when an end is not free.");
}

}  // namespace taut::python
