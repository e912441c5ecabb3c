// The Python module's parts, a file a subject, and what they share.
//
// Arrays: points are float64 (n, 2), walls and queries (n, 4). What the library holds is shown without a copy, read
// only, and lives as long as the array; what a call returns is moved into its array. All that takes long lets go of
// Python's lock, so that other threads run.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/length.h>
#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut::python {

namespace py = pybind11;

using Unlocked = py::call_guard<py::gil_scoped_release>;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

// ---- errors.cpp -----------------------------------------------------------------------------------------------------
/// Nothing was found, which proves nothing.
class Unproven : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An InputError whose parts are known: `what()` of an error about a source begins with it.
class Refusal : public std::runtime_error {
 public:
  Refusal(const InputError& error, const std::string& source);

  std::string file;     ///< empty: none
  int line = 0;         ///< 0: none
  std::string culprit;  ///< the message without both
};

/// Runs `ask`; what it refuses is about `source`.
template <class Ask>
auto about(const std::string& source, Ask&& ask) {
  try {
    return ask();
  } catch (const InputError& error) {
    throw Refusal(error, source);
  }
}

// ---- arrays.cpp -----------------------------------------------------------------------------------------------------
/// x and y of `value`: a pair, an array of two numbers, or what has x and y, as shapely's points. Else nothing.
std::optional<Point> point_of(py::handle value);
/// May the library be asked about it: are the coordinates 0 or of a magnitude that a World can have?
bool is_in_reach(Point p);
/// A point, or boxes xmin, ymin, xmax, ymax: a room. TypeError for all else.
Goal goal_of(py::handle value);
/// An array of `columns` numbers a row, or of none; ValueError with `what` and the shape for all else.
Doubles rows_of(py::handle value, py::ssize_t columns, const char* what);
/// From (n, 2).
std::vector<Point> points_of(py::handle value, const char* what);
/// A ring (n, 2), the outer ring and holes, or what has a __geo_interface__ of a polygon.
Polygon polygon_of(py::handle value);

py::array points_array(std::vector<Point> points);
py::array segments_array(std::span<const Segment> segments);
py::tuple polygon_tuple(const Polygon& polygon);  ///< of arrays: the outer ring, then holes
py::object goal_object(const Goal& goal);         ///< as goal_of takes it; None without one
/// Points that `owner` holds, without a copy.
py::array points_view(std::span<const Point> points, py::handle owner);

py::array read_only(py::array array);

/// Values that are moved into an array.
template <class T>
py::array moved(std::vector<T> values, std::vector<py::ssize_t> shape = {}) {
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  if (shape.empty()) shape = {static_cast<py::ssize_t>(kept->size())};
  return py::array_t<T>(shape, kept->data(), owner);
}

/// Values that `owner` holds, without a copy.
template <class T>
py::array view(const T* values, std::vector<py::ssize_t> shape, py::handle owner) {
  return read_only(py::array_t<T>(std::move(shape), values, owner));
}

// ---- the parts, in the order in which they need each other ----------------------------------------------------------
void bind_errors(py::module_& m);
void bind_lengths(py::module_& m);
void bind_worlds(py::module_& m);
void bind_reading(py::module_& m);
void bind_free_spaces(py::module_& m);
void bind_paths(py::module_& m);
void bind_polyanya(py::module_& m);
void bind_indexes(py::module_& m);
void bind_roadmaps(py::module_& m);
void bind_planners(py::module_& m);
void bind_discs(py::module_& m);
void bind_passage_index(py::module_& m);
void bind_clearance(py::module_& m);
void bind_tradeoff(py::module_& m);
void bind_snapping(py::module_& m);
void bind_grids(py::module_& m);
void bind_mice(py::module_& m);
void bind_chases(py::module_& m);
void bind_meetings(py::module_& m);
void bind_bugs(py::module_& m);
void bind_cars(py::module_& m);

}  // namespace taut::python

namespace pybind11::detail {

/// A Point is a pair in Python.
template <>
struct type_caster<taut::Point> {
  PYBIND11_TYPE_CASTER(taut::Point, const_name("tuple[float, float]"));

  bool load(handle source, bool) {
    const auto point = taut::python::point_of(source);
    if (point) value = *point;
    return point.has_value();
  }

  static handle cast(taut::Point p, return_value_policy, handle) { return make_tuple(p.x, p.y).release(); }
};

/// A Goal is a pair, or an array of boxes; None without one.
template <>
struct type_caster<taut::Goal> {
  PYBIND11_TYPE_CASTER(taut::Goal, const_name("tuple[float, float]"));

  bool load(handle source, bool) {
    if (source.is_none()) return true;
    value = taut::python::goal_of(source);
    return value.point || !value.room.empty();
  }

  static handle cast(const taut::Goal& goal, return_value_policy, handle) {
    return taut::python::goal_object(goal).release();
  }
};

}  // namespace pybind11::detail
