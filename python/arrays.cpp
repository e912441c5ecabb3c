#include <fmt/format.h>

#include <cmath>

#include <taut/python/bind.h>

namespace taut::python {

namespace {

std::optional<double> number_of(py::handle value) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number != -1 || !PyErr_Occurred()) return number;
  PyErr_Clear();
  return std::nullopt;
}

std::optional<Point> pair_of(py::handle x, py::handle y) {
  const auto a = number_of(x), b = number_of(y);
  if (!a || !b) return std::nullopt;
  return Point{*a, *b};
}

bool is_text(py::handle value) { return py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value); }

Ring ring_of(py::handle value) {
  Ring ring = points_of(value, "a ring");
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

Polygon polygon_of_rings(py::handle rings) {
  Polygon polygon;
  bool outer = true;
  for (const py::handle ring : rings) {
    outer ? polygon.outer = ring_of(ring) : polygon.holes.emplace_back(ring_of(ring));
    outer = false;
  }
  return polygon;
}

// Is the first element of the first one a number?
bool is_ring(py::handle value) {
  if (py::isinstance<py::array>(value)) return py::reinterpret_borrow<py::array>(value).ndim() == 2;
  const py::sequence outer = py::reinterpret_borrow<py::sequence>(value);
  if (outer.size() == 0) return true;
  return point_of(outer[0]).has_value();
}

}  // namespace

std::optional<Point> point_of(py::handle value) {
  if (PyTuple_CheckExact(value.ptr()) && PyTuple_GET_SIZE(value.ptr()) == 2)
    return pair_of(PyTuple_GET_ITEM(value.ptr(), 0), PyTuple_GET_ITEM(value.ptr(), 1));
  if (value.is_none() || is_text(value)) return std::nullopt;
  if (PySequence_Check(value.ptr()) && !py::hasattr(value, "geom_type")) {
    const py::ssize_t size = PySequence_Size(value.ptr());
    if (size < 0) PyErr_Clear();
    if (size != 2) return std::nullopt;
    const py::sequence pair = py::reinterpret_borrow<py::sequence>(value);
    return pair_of(py::object(pair[0]), py::object(pair[1]));
  }
  if (!py::hasattr(value, "x") || !py::hasattr(value, "y")) return std::nullopt;
  return pair_of(value.attr("x"), value.attr("y"));
}

bool is_in_reach(Point p) {
  const auto fits = [](double v) {
    return v == 0 || (std::abs(v) >= World::kSmallest && std::abs(v) <= World::kLargest);
  };
  return fits(p.x) && fits(p.y);
}

Goal goal_of(py::handle value) {
  if (const auto point = point_of(value)) return {point, {}};
  if (!PySequence_Check(value.ptr()) || is_text(value)) throw py::type_error("a goal is a point, or boxes (n, 4)");
  Goal goal;
  const Doubles boxes = rows_of(value, 4, "a room");
  for (py::ssize_t i = 0; i < boxes.shape(0); ++i) {
    const double* row = boxes.data(i, 0);
    const Box box{{row[0], row[1]}, {row[2], row[3]}};
    const bool is_box = is_in_reach(box.min) && is_in_reach(box.max) && row[0] <= row[2] && row[1] <= row[3];
    if (!is_box) throw py::value_error("a room: boxes xmin, ymin, xmax, ymax");
    goal.room.push_back(box);
  }
  return goal;
}

Doubles rows_of(py::handle value, py::ssize_t columns, const char* what) {
  Doubles array = Doubles::ensure(value);
  if (!array) {
    PyErr_Clear();
    throw py::value_error(fmt::format("{}: numbers, {} a row", what, columns));
  }
  if (array.size() == 0) return Doubles(std::vector<py::ssize_t>{0, columns});
  if (array.ndim() == 1 && array.size() == columns) return array.reshape({py::ssize_t{1}, columns});
  if (array.ndim() == 3 && array.shape(1) * array.shape(2) == columns) return array.reshape({array.shape(0), columns});
  if (array.ndim() == 2 && array.shape(1) == columns) return array;
  std::string shape;
  for (py::ssize_t i = 0; i < array.ndim(); ++i) shape += (i ? ", " : "") + std::to_string(array.shape(i));
  throw py::value_error(fmt::format("{}: the shape is ({}), not (n, {})", what, shape, columns));
}

std::vector<Point> points_of(py::handle value, const char* what) {
  if (py::hasattr(value, "coords")) return points_of(py::list(value.attr("coords")), what);
  const Doubles rows = rows_of(value, 2, what);
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) points.push_back({rows.at(i, 0), rows.at(i, 1)});
  return points;
}

Polygon polygon_of(py::handle value) {
  if (py::hasattr(value, "__geo_interface__")) {
    const py::dict geometry = value.attr("__geo_interface__");
    if (geometry["type"].cast<std::string>() != "Polygon")
      throw py::type_error("not a polygon: " + std::string(py::repr(value)));
    return polygon_of_rings(geometry["coordinates"]);
  }
  if (!PySequence_Check(value.ptr()) || is_text(value)) throw py::type_error("a polygon is a ring (n, 2), or rings");
  return is_ring(value) ? Polygon{ring_of(value), {}} : polygon_of_rings(value);
}

py::array read_only(py::array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::array points_array(std::vector<Point> points) {
  auto* kept = new std::vector<Point>(std::move(points));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Point>*>(p); });
  const auto n = static_cast<py::ssize_t>(kept->size());
  return py::array_t<double>({n, py::ssize_t{2}}, n ? &kept->front().x : nullptr, owner);
}

py::array segments_array(std::span<const Segment> segments) {
  const auto n = static_cast<py::ssize_t>(segments.size());
  py::array_t<double> array({n, py::ssize_t{4}});
  auto rows = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < n; ++i) {
    const Segment& s = segments[static_cast<std::size_t>(i)];
    rows(i, 0) = s.a.x, rows(i, 1) = s.a.y, rows(i, 2) = s.b.x, rows(i, 3) = s.b.y;
  }
  return array;
}

py::array points_view(std::span<const Point> points, py::handle owner) {
  const auto n = static_cast<py::ssize_t>(points.size());
  return view(n ? &points.front().x : nullptr, {n, 2}, owner);
}

py::tuple polygon_tuple(const Polygon& polygon) {
  py::tuple rings(1 + polygon.holes.size());
  rings[0] = points_array(polygon.outer);
  for (std::size_t i = 0; i < polygon.holes.size(); ++i) rings[i + 1] = points_array(polygon.holes[i]);
  return rings;
}

py::object goal_object(const Goal& goal) {
  if (goal.point) return py::cast(*goal.point);
  if (goal.room.empty()) return py::none();
  std::vector<Segment> boxes;
  for (const Box& box : goal.room) boxes.push_back({box.min, box.max});
  return segments_array(boxes);
}

}  // namespace taut::python
