#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include <taut/io/results/barrier_words.h>
#include <taut/io/results/tradeoff_json.h>
#include <taut/io/results/words.h>
#include <taut/python/answers.h>
#include <taut/python/wishes.h>
#include <taut/search/radius_tradeoff.h>

namespace taut::python {

namespace {

struct Stretch {
  TradeoffStretch way;
  Point start, goal;
  std::string then;
};

std::vector<Stretch> tradeoff(const FreeSpace& space, const std::optional<Point>& start, const Goal& goal) {
  require_point_robot(space);
  const Point from = start_of(space.world(), start);
  const Goal to = goal_of_query(space.world(), goal);
  if (!to.point) throw InputError("", 0, "the goal of a disc is a point");
  const py::gil_scoped_release unlocked;
  require_ends(space, from, to);
  const PassageIndex index(space);
  std::vector<Stretch> result;
  for (TradeoffStretch& way : radius_tradeoff(AllRadii(space), index, from, *to.point).stretches) {
    std::string then = stretch_end_text(way, index.gates());
    result.push_back({std::move(way), from, *to.point, std::move(then)});
  }
  return result;
}

double radius_within(const Stretch& stretch, double r) {
  if (!(stretch.way.from <= r && r <= stretch.way.to)) throw py::value_error("radius: not one of this stretch");
  return r;
}

std::vector<Point> points(const Stretch& stretch, double r) {
  std::vector<Point> points;
  if (stretch.way.start != stretch.start) points.push_back(stretch.start);
  const std::vector<Point> way = sampled(stretch.way.path(r), r / 1000);
  points.insert(points.end(), way.begin(), way.end());
  if (stretch.way.goal != stretch.goal) points.push_back(stretch.goal);
  return points;
}

}  // namespace

void bind_tradeoff(py::module_& m) {
  py::class_<Stretch>(m, "TradeoffStretch", "Radii of discs whose shortest way bends around the same corners.")
      .def_property_readonly(
          "radii", [](const Stretch& s) { return py::make_tuple(s.way.from, s.way.to); }, "The least and the largest.")
      .def_property_readonly(
          "lengths", [](const Stretch& s) { return py::make_tuple(s.way.at_from.middle(), s.way.at_to.middle()); },
          "Of their ways.")
      .def_readonly("then", &Stretch::then, "What happens beyond, in words.")
      .def(
          "length", [](const Stretch& s, double r) { return s.way.length(radius_within(s, r)); }, py::arg("radius"),
          "Of the shortest way of that disc.")
      .def(
          "points", [](const Stretch& s, double r) { return points_array(points(s, radius_within(s, r))); },
          py::arg("radius"), "(n, 2): on that way, legs between them no farther from it than radius / 1000.")
      .def("__repr__", [](const Stretch& s) {
        return fmt::format("<taut.TradeoffStretch up to {}, length {} to {}>", number_text(s.way.to),
                           plain_length(s.way.at_from.middle()), plain_length(s.way.at_to.middle()));
      });
  m.def("tradeoff", &tradeoff, py::arg("space"), py::arg("start") = py::none(), py::arg("goal") = py::none(),
        "What room costs: a TradeoffStretch for each radius at which the shortest way of a disc changes, up to the "
        "largest disc that gets through; [] where none does. In a point's space.");
}

}  // namespace taut::python
