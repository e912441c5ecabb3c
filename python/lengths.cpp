#include <pybind11/operators.h>

#include <taut/io/results/words.h>
#include <taut/python/answers.h>

namespace taut::python {

namespace {

Length length_of(const py::object& given) {
  const std::vector<Point> points = points_of(given, "points");
  for (const Point p : points)
    if (!is_in_reach(p)) throw InputError("", 0, "points: not all are points");
  return Length(points);
}

}  // namespace

std::string decimals_of(const Length& length, int places) {
  if (places < 0 || places > 100'000) throw py::value_error("places: 0 to 100000");
  return length.decimals(places);
}

void bind_lengths(py::module_& m) {
  py::class_<Length>(m, "Length",
                     "The length of a chain of points: a sum of square roots, kept as such. Compared exactly; "
                     "float() is the nearest double.")
      .def(py::init(&length_of), py::arg("points") = py::tuple(), "Of the chain through the points (n, 2).")
      .def("decimals", &decimals_of, py::arg("places"), "The nearest number with that many decimals, as text.")
      .def_property_readonly("terms", &Length::terms, "How many square roots it is a sum of.")
      .def("__float__", &Length::value)
      .def("__add__",
           [](const Length& a, const Length& b) {
             Length sum = a;
             return sum += b;
           })
      .def(
          "__eq__", [](const Length& a, const Length& b) { return a == b; }, py::is_operator())
      .def(
          "__ne__", [](const Length& a, const Length& b) { return a != b; }, py::is_operator())
      .def(
          "__lt__", [](const Length& a, const Length& b) { return a < b; }, py::is_operator())
      .def(
          "__le__", [](const Length& a, const Length& b) { return a <= b; }, py::is_operator())
      .def(
          "__gt__", [](const Length& a, const Length& b) { return a > b; }, py::is_operator())
      .def(
          "__ge__", [](const Length& a, const Length& b) { return a >= b; }, py::is_operator())
      .def("__hash__", [](const Length& a) { return std::hash<double>{}(a.value()); })
      .def("__repr__", [](const Length& a) { return "Length(" + length_text(a) + ")"; });
}

}  // namespace taut::python
