#include <fmt/format.h>

#include <taut/geometry/footprint.h>
#include <taut/geometry/nearest_free.h>
#include <taut/geometry/rounding.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>
#include <taut/python/bind.h>
#include <taut/search/query_ends.h>

namespace taut::python {

namespace {

void require(const FreeSpace& space, Point p) {
  about(space.world().source(), [&] { require_free(space, p, "point"); });
}

py::list polygons_of(const FreeSpace& space) {
  py::list polygons;
  for (const Polygon& polygon : space.polygons()) polygons.append(polygon_tuple(polygon));
  return polygons;
}

py::array constraints_of(const FreeSpace& space) {
  std::vector<Segment> pieces;
  for (const Constraint& piece : space.constraints()) pieces.push_back({piece.a, piece.b});
  return segments_array(pieces);
}

py::tuple triangles_of(const py::object& self) {
  const Triangulation& mesh = self.cast<const FreeSpace&>().triangulation();
  const auto n = static_cast<py::ssize_t>(mesh.triangles.size());
  const std::uint32_t* triangles = n ? mesh.triangles.front().data() : nullptr;
  return py::make_tuple(points_view(mesh.points, self), view(triangles, {n, 3}, self),
                        view(mesh.free.data(), {n}, self));
}

py::array separation_of(const FreeSpace& space, Point p, Point q) {
  require(space, p);
  require(space, q);
  std::vector<Segment> pieces;
  for (const Constraint& piece : space.separation(p, q)) pieces.push_back({piece.a, piece.b});
  return segments_array(pieces);
}

py::array_t<double> clearances_of(const FreeSpace& space, const py::object& given) {
  const std::vector<Point> points = points_of(given, "points");
  std::vector<double> clearances;
  clearances.reserve(points.size());
  {
    const py::gil_scoped_release unlocked;
    for (const Point p : points) {
      const bool outside = !is_in_reach(p) || space.locate(p).kind == Location::Kind::outside;
      clearances.push_back(outside ? -1 : space.clearance(p).distance);
    }
  }
  return moved(std::move(clearances));
}

std::string text(const Footprint& footprint) {
  switch (footprint.kind()) {
    case Footprint::Kind::point: return "point";
    case Footprint::Kind::disc: return "disc of radius " + number_text(footprint.radius());
    case Footprint::Kind::polygon: break;
  }
  return fmt::format("polygon of {} corners", footprint.ring().size());
}

void bind_footprint(py::module_& m) {
  py::class_<Footprint>(m, "Footprint", "What moves: the shape of the robot around its reference point.")
      .def_static("point", &Footprint::point)
      .def_static(
          "disc",
          [](double r) {
            if (!(r > 0 && r <= World::kLargest)) throw InputError("", 0, "a disc's radius is above 0");
            return Footprint::disc(r);
          },
          py::arg("radius"), "A disc around its centre; taken for the polygon with 64 sides around it.")
      .def_static(
          "square",
          [](double r) {
            if (!(r > 0 && r <= World::kLargest)) throw InputError("", 0, "a square's half side is above 0");
            return Footprint::square(r);
          },
          py::arg("half_side"), "An axis-parallel square, its reference point in the middle.")
      .def_static(
          "polygon", [](const py::object& ring) { return Footprint::polygon(points_of(ring, "a ring")); },
          py::arg("ring"), "A convex counter-clockwise polygon (n, 2) around the origin. Raises InputError.")
      .def_property_readonly("radius", &Footprint::radius, "Of a disc; of a square its half side; else 0.")
      .def_property_readonly(
          "ring", [](const Footprint& f) { return points_array(f.ring()); }, "(n, 2): the polygon; empty for a point.")
      .def("__repr__", [](const Footprint& f) { return "<taut.Footprint " + text(f) + ">"; });
}

void bind_places(py::class_<FreeSpace>& space) {
  space
      .def(
          "is_free",
          [](const FreeSpace& s, Point p) { return is_in_reach(p) && s.locate(p).kind != Location::Kind::outside; },
          py::arg("point"), "Can the robot be there? Exact.")
      .def(
          "sees", [](const FreeSpace& s, Point p, Point q) { return is_in_reach(p) && is_in_reach(q) && s.sees(p, q); },
          py::arg("p"), py::arg("q"), "Can a path go straight from p to q? Exact. False when one is not free.")
      .def(
          "clearance",
          [](const FreeSpace& s, Point p) {
            require(s, p);
            return s.clearance(p).distance;
          },
          py::arg("point"), "The distance to the nearest obstacle. Raises InputError when the point is not free.")
      .def("clearances", &clearances_of, py::arg("points"), "(n,): of points (n, 2); -1 of those that are not free.")
      .def(
          "visibility_polygon",
          [](const FreeSpace& s, Point p) {
            require(s, p);
            return points_array(s.visibility_polygon(p).ring);
          },
          py::arg("point"), "(n, 2): the outline of what is seen, counter-clockwise. Raises InputError.")
      .def(
          "nearest_free",
          [](const FreeSpace& s, Point p) -> std::optional<Point> {
            if (!is_in_reach(p)) throw InputError("", 0, "not a point");
            const auto place = nearest_free(s, p);
            return place ? std::optional(place->point) : std::nullopt;
          },
          py::arg("point"), "The nearest place for the robot; the point itself when it is one. None without any place.")
      .def("separation", &separation_of, py::arg("p"), py::arg("q"),
           "(n, 4): the closed chain of walls that keeps them apart; no rows when nothing does.");
}

std::string repr(const FreeSpace& space) {
  return fmt::format("<taut.FreeSpace of a {}: {}, {}>", text(space.footprint()),
                     count_text(space.polygons().size(), "polygon"),
                     count_text(space.triangulation().triangles.size(), "triangle"));
}

std::string picture(const FreeSpace& space) {
  const World& world = space.world();
  return svg(space, {.title = title_of(world.source()), .start = world.start(), .goal = world.goal()});
}

FreeSpace made_space(const World& world, const Footprint& footprint, const py::object& places) {
  const std::vector<Point> known = places.is_none() ? std::vector<Point>{} : points_of(places, "places");
  const py::gil_scoped_release unlocked;
  return about(world.source(), [&] { return FreeSpace(world, footprint, known); });
}

}  // namespace

void bind_free_spaces(py::module_& m) {
  bind_footprint(m);
  py::class_<FreeSpace> space(m, "FreeSpace", "Where the robot's reference point may be. Immutable.");
  space
      .def(py::init(&made_space), py::arg("world"), py::arg("footprint") = Footprint::point(),
           py::arg("places") = py::none(),
           "places: points (n, 2) that will be asked about; only where a sloped wall was bent by rounding does that "
           "matter. Raises InputError, TooFine.")
      .def_property_readonly("world", &FreeSpace::world, py::return_value_policy::copy)
      .def_property_readonly("footprint", &FreeSpace::footprint, py::return_value_policy::copy)
      .def_property_readonly("polygons", &polygons_of, "Tuples of rings (n, 2): the outer one and holes.")
      .def_property_readonly("constraints", &constraints_of, "(n, 4): everything that stops a path.")
      .def_property_readonly("component_count", &FreeSpace::component_count, "How many connected parts there are.")
      .def_property_readonly(
          "displacement", [](const FreeSpace& s) { return s.report().displacement; },
          "The largest distance by which a crossing was rounded.")
      .def_property_readonly("within", &rounding_bound,
                             "How far an obstacle may lie from where it is written: 0, or "
                             "where crossings were rounded a bit more.")
      .def_property_readonly("triangulation", &triangles_of,
                             "points (p, 2), triangles (n, 3) as indices of them, free (n,): 1 where a path may be.")
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", &repr);
  bind_places(space);
}

}  // namespace taut::python
