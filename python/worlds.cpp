#include <fmt/format.h>

#include <array>
#include <memory>

#include <taut/geometry/snap.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>
#include <taut/io/worlds/read_world.h>
#include <taut/io/worlds/write_world.h>
#include <taut/python/bind.h>
#include <taut/python/reading.h>

namespace taut::python {

namespace {

constexpr std::array<const char*, 3> kBoundaries{"walled", "limit", "open"};

Boundary boundary_named(const std::string& word) {
  for (std::size_t i = 0; i < kBoundaries.size(); ++i)
    if (word == kBoundaries[i]) return static_cast<Boundary>(i);
  throw py::value_error("boundary: 'walled', 'limit' or 'open', not '" + word + "'");
}

std::vector<Wall> walls_of(const py::object& walls, const py::object& thickness) {
  std::vector<Wall> made;
  if (walls.is_none()) return made;
  const Doubles rows = rows_of(walls, 4, "walls"), thick = Doubles::ensure(thickness);
  if (!thick || (thick.ndim() != 0 && thick.size() != rows.shape(0))) {
    PyErr_Clear();
    throw py::value_error("thickness: a number, or one a wall");
  }
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    made.push_back(
        {{rows.at(i, 0), rows.at(i, 1)}, {rows.at(i, 2), rows.at(i, 3)}, thick.data()[thick.ndim() == 0 ? 0 : i]});
  return made;
}

std::vector<Area> areas_of(const py::object& polygons) {
  std::vector<Area> areas;
  if (polygons.is_none()) return areas;
  for (const py::handle polygon : polygons) areas.push_back({polygon_of(polygon)});
  return areas;
}

World made_world(const py::object& walls, const py::object& thickness, const py::object& areas,
                 const py::object& solids, const std::string& boundary, const std::optional<Point>& start,
                 const Goal& goal, const py::object& snap, const std::string& source) {
  WorldParts parts;
  parts.source = source;
  parts.walls = walls_of(walls, thickness);
  parts.areas = areas_of(areas);
  parts.solids = areas_of(solids);
  parts.boundary = boundary_named(boundary);
  parts.start = start;
  parts.goal = goal;
  const Snap wanted = snap_of(snap);
  const py::gil_scoped_release unlocked;
  return about(source, [&] { return snapped_world(parts, wanted).world; });
}

py::list polygons_of(const std::vector<Area>& areas) {
  py::list polygons;
  for (const Area& area : areas) polygons.append(polygon_tuple(area.polygon));
  return polygons;
}

py::array walls_array(const World& world) {
  std::vector<Segment> walls;
  for (const Wall& wall : world.walls()) walls.push_back({wall.a, wall.b});
  return segments_array(walls);
}

py::array thickness_array(const World& world) {
  std::vector<double> thickness;
  for (const Wall& wall : world.walls()) thickness.push_back(wall.thickness);
  return moved(std::move(thickness));
}

std::string repr(const World& world) {
  return fmt::format("<taut.World {}{}, {}>", world.source().empty() ? "" : world.source() + ": ",
                     count_text(world.walls().size(), "wall"), count_text(world.solids().size(), "solid"));
}

py::bytes written(const World& world, const std::string& format) {
  const std::optional<Format> as = format_named(format);
  if (!as) throw py::value_error("format: no such format '" + format + "'");
  return about(world.source(), [&] { return write_world(world, *as); });
}

std::string picture(const World& world) {
  return svg(FreeSpace(world), {.title = title_of(world.source()), .start = world.start(), .goal = world.goal()});
}

constexpr const char* kMake = R"(A world of arrays.

walls: (n, 4) x1 y1 x2 y2, or (n, 2, 2). thickness: of all walls, or one a wall; 0 is a wall that a path may touch.
areas: polygons where the world is; solids: polygons that are obstacles. A polygon is a ring (n, 2), a list of rings
(the outer one, then holes), or what has a __geo_interface__ of one (shapely's polygons). boundary: of areas; 'walled':
solid outside, 'limit': one may not leave, 'open'. start, goal: points; a goal may be a room, boxes (n, 4).
snap: None joins what lies within rounding, a number what is no farther apart, 'auto', 0 nothing.
Raises InputError.)";

}  // namespace

void bind_worlds(py::module_& m) {
  py::class_<World> world(m, "World", "What stands where, before any robot is chosen. Immutable, checked.");
  world
      .def(py::init(&made_world), py::arg("walls") = py::none(), py::kw_only(), py::arg("thickness") = 0.0,
           py::arg("areas") = py::none(), py::arg("solids") = py::none(), py::arg("boundary") = "limit",
           py::arg("start") = py::none(), py::arg("goal") = py::none(), py::arg("snap") = py::none(),
           py::arg("source") = "", kMake)
      .def_property_readonly("source", &World::source, "The file's name; may be empty.")
      .def_property_readonly("walls", &walls_array, "(n, 4): x1 y1 x2 y2.")
      .def_property_readonly("thickness", &thickness_array, "(n,): of each wall.")
      .def_property_readonly(
          "areas", [](const World& w) { return polygons_of(w.areas()); },
          "Polygons: tuples of rings (n, 2), the outer one and holes.")
      .def_property_readonly(
          "solids", [](const World& w) { return polygons_of(w.solids()); }, "Polygons that are obstacles.")
      .def_property_readonly(
          "boundary", [](const World& w) { return kBoundaries[static_cast<std::size_t>(w.boundary())]; },
          "'walled', 'limit' or 'open'.")
      .def_property_readonly("start", &World::start, "A point, or None.")
      .def_property_readonly("goal", &World::goal, "A point, a room as boxes (n, 4), or None.")
      .def_property_readonly(
          "box",
          [](const World& w) { return py::make_tuple(w.box().min.x, w.box().min.y, w.box().max.x, w.box().max.y); },
          "xmin, ymin, xmax, ymax of the areas.")
      .def_property_readonly(
          "openings", [](const World& w) { return segments_array(w.openings()); },
          "(n, 4): the pieces of the outline on which no wall stands.")
      .def_property_readonly("y_down", &World::y_down, "Pictures show its y growing downwards.")
      .def_property_readonly("uncertainty", &World::uncertainty, "How far from where it was meant a place may lie.")
      .def("with_ends", &World::with_ends, py::arg("start") = py::none(), py::arg("goal") = py::none(),
           "A copy with another start, goal (a point); an absent one stays. Raises InputError.")
      .def("with_wall_thickness", &World::with_wall_thickness, py::arg("thickness"),
           "A copy whose walls all are so thick. Raises InputError.")
      .def("write", &written, py::arg("format") = "geojson", "The bytes of a file that read_world reads back.")
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", &repr);
}

}  // namespace taut::python
