#include <fmt/format.h>

#include <taut/geometry/rounding.h>
#include <taut/io/pictures/alternatives_svg.h>
#include <taut/io/pictures/kept_svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/words.h>
#include <taut/python/answers.h>
#include <taut/python/wishes.h>
#include <taut/search/alternatives.h>
#include <taut/search/disc_reach.h>
#include <taut/search/kept_path.h>
#include <taut/search/passage_map.h>
#include <taut/search/query_ends.h>

namespace taut::python {

namespace {

/// Both ends of a query from point to point.
std::pair<Point, Point> ends_of(const FreeSpace& space, const std::optional<Point>& start, const Goal& goal) {
  const Point from = start_of(space.world(), start);
  const Goal to = goal_of_query(space.world(), goal);
  if (!to.point) throw InputError("", 0, "the goal is a point here");
  require_ends(space, from, to);
  return {from, *to.point};
}

py::array widths_of(const Gates& gates, const std::vector<std::uint32_t>& some) {
  std::vector<double> widths;
  for (const std::uint32_t i : some) widths.push_back(gates.gates()[i].width);
  return moved(std::move(widths));
}

py::array segments_of(const Gates& gates, const std::vector<std::uint32_t>& some) {
  std::vector<Segment> segments;
  for (const std::uint32_t i : some) segments.push_back({gates.gates()[i].end, gates.gates()[i].foot});
  return segments_array(segments);
}

// ---- the index ------------------------------------------------------------------------------------------------------

struct Reached {
  PassageIndex index;
  Point start;
  double radius;
  DiscReach reach;
};

std::optional<Reached> reach(const PassageIndex& index, double radius, const std::optional<Point>& start) {
  require_radius(radius);
  const Point from = start_of(index.gates().space().world(), start);
  const py::gil_scoped_release unlocked;
  auto found = disc_reach(index, from, radius);
  if (!found) return std::nullopt;
  return Reached{index, from, radius, std::move(*found)};
}

py::list polygons(const Reached& r) {
  py::list all;
  for (const Polygon& polygon : r.reach.places) all.append(polygon_tuple(polygon));
  return all;
}

py::array matrix(const PassageIndex& index, const py::object& points) {
  const std::vector<Point> rows = points_of(points, "points");
  const auto n = static_cast<py::ssize_t>(rows.size());
  std::vector<double> radii;
  {
    const py::gil_scoped_release unlocked;
    radii = passage_matrix(index, rows);
  }
  return moved(std::move(radii), {n, n});
}

py::list map(const PassageIndex& index, const std::optional<Point>& start) {
  py::list faces;
  for (PassageFace& face : passage_map(index, start_of(index.gates().space().world(), start)))
    faces.append(py::make_tuple(points_array(std::move(face.outline)), face.radius));
  return faces;
}

std::optional<double> widest(const PassageIndex& index, const std::optional<Point>& start, const Goal& goal) {
  const auto [from, to] = ends_of(index.gates().space(), start, goal);
  const auto found = index.widest(from, to);
  return found ? std::optional(found->radius) : std::nullopt;
}

bool passes(const PassageIndex& index, double radius, const std::optional<Point>& start, const Goal& goal) {
  require_radius(radius);
  const auto [from, to] = ends_of(index.gates().space(), start, goal);
  return index.passes(from, to, radius) == DiscStatus::found;
}

py::object nearest(const PassageIndex& index, double radius, Point p) {
  require_radius(radius);
  const auto place = DiscPlaces(index.gates().space(), radius).nearest(p);
  if (!place) return py::none();
  return py::make_tuple(place->point, place->distance);
}

void bind_index(py::module_& m) {
  py::class_<Reached>(m, "DiscReach", "Where a disc's centre gets to from one place.")
      .def_property_readonly(
          "polygons", &polygons,
          "Each the outer ring, then holes, (n, 2). Arcs are drawn by a 64-gon around the disc, so a "
          "rim of 0.121 % of the radius is left out; which are reached is exact.")
      .def_property_readonly("area", [](const Reached& r) { return r.reach.area; })
      .def_property_readonly(
          "whole_area", [](const Reached& r) { return r.reach.whole_area; }, "Of all places, reached or not.")
      .def_property_readonly(
          "gates", [](const Reached& r) { return segments_of(r.index.gates(), r.reach.gates); },
          "(n, 4): too narrow, between what is reached and what is not, the widest first.")
      .def_property_readonly(
          "widths", [](const Reached& r) { return widths_of(r.index.gates(), r.reach.gates); }, "(n,): theirs.")
      .def(
          "__contains__",
          [](const Reached& r, Point p) { return r.index.passes(r.start, p, r.radius) == DiscStatus::found; },
          "Does the centre get there? Exactly.")
      .def("__repr__", [](const Reached& r) {
        return fmt::format("<taut.DiscReach radius {}: area {:.6g} of {:.6g}>", number_text(r.radius), r.reach.area,
                           r.reach.whole_area);
      });
  py::class_<PassageIndex>(m, "PassageIndex",
                           "Where a disc of any radius gets to, and how wide it is: one index for all "
                           "radii and ends, microseconds a question. Of a point's space; exact.")
      .def(py::init([](const FreeSpace& space) {
             require_point_robot(space);
             const py::gil_scoped_release unlocked;
             return PassageIndex(space);
           }),
           py::arg("space"))
      .def_property_readonly("gates", &PassageIndex::gates)
      .def("widest", &widest, py::arg("start") = py::none(), py::arg("goal") = py::none(),
           "The radius of the largest disc that gets from start to goal; None: not even a point does.")
      .def("passes", &passes, py::arg("radius"), py::arg("start") = py::none(), py::arg("goal") = py::none(),
           "Does a disc get there? False also where it cannot be at an end.")
      .def("matrix", &matrix, py::arg("points"),
           "(n, n): the radii of the largest discs between each two of (n, 2) points; 0 where none gets.")
      .def("map", &map, py::arg("start") = py::none(),
           "[(ring, radius), ...]: the faces between walls and gates, and the largest disc that gets into each; the "
           "widest first.")
      .def("reach", &reach, py::arg("radius"), py::arg("start") = py::none(),
           "The DiscReach of a disc; None where it cannot be at the start.")
      .def("nearest_place", &nearest, py::arg("radius"), py::arg("point"),
           "The place of a disc's centre that is nearest to the point, and its distance; None: there is none at all.")
      .def("__repr__", [](const PassageIndex& index) {
        return fmt::format("<taut.PassageIndex of {}>", count_text(index.gates().gates().size(), "gate"));
      });
}

// ---- ways -----------------------------------------------------------------------------------------------------------

struct Kept {
  PassageIndex index;
  Point start, goal;
  KeptPath path;
};

std::optional<Kept> keep(const PassageIndex& index, double clearance, const std::optional<Point>& start,
                         const Goal& goal) {
  require_radius(clearance);
  const auto [from, to] = ends_of(index.gates().space(), start, goal);
  const py::gil_scoped_release unlocked;
  KeptPath path = kept_path(index, from, to, clearance);
  if (path.status != KeptPath::Status::found) return std::nullopt;
  return Kept{index, from, to, std::move(path)};
}

std::vector<Point> points_of_part(const ArcPath& part) {
  return part.bends.empty() ? std::vector<Point>{part.start, part.goal} : sampled(part, part.radius / 1000);
}

py::list parts(const Kept& kept) {
  py::list all;
  for (const ArcPath& part : kept.path.parts)
    all.append(py::make_tuple(part.radius, points_array(points_of_part(part))));
  return all;
}

py::array points(const Kept& kept) {
  std::vector<Point> all{kept.start};
  for (const ArcPath& part : kept.path.parts) {
    const std::vector<Point> more = points_of_part(part);
    all.insert(all.end(), more.begin() + 1, more.end());
  }
  return points_array(std::move(all));
}

void bind_kept(py::module_& m) {
  py::class_<Kept>(m, "KeptPath", "The shortest path that keeps a clearance, with arcs, where its ends allow.")
      .def_property_readonly("length", [](const Kept& k) { return k.path.length.middle(); })
      .def_property_readonly(
          "length_bounds", [](const Kept& k) { return py::make_tuple(k.path.length.lo, k.path.length.hi); },
          "Two doubles around the exact length.")
      .def_property_readonly("clearance", [](const Kept& k) { return k.path.clearance; })
      .def_property_readonly(
          "parts", &parts,
          "[(radius, points), ...]: what each part keeps from walls, and (n, 2) points on it, legs between them no "
          "farther from it than radius / 1000. Those below the clearance leave the start and enter the goal.")
      .def_property_readonly("points", &points, "(n, 2): of all parts.")
      .def(
          "verify", [](const Kept& k) { return kept_path_fault(k.path, k.index, k.start, k.goal).empty(); }, Unlocked(),
          "A check that shares nothing with the planner: True when each part keeps what it says.")
      .def(
          "_repr_svg_",
          [](const Kept& k) {
            const FreeSpace& space = k.index.gates().space();
            return kept_svg({k.start, k.goal, k.path, false, {}, {}}, space, title_of(space.world().source()));
          },
          Unlocked())
      .def("__repr__", [](const Kept& k) {
        return fmt::format("<taut.KeptPath length {}, clearance {}, {}>", plain_length(k.path.length.middle()),
                           number_text(k.path.clearance), count_text(k.path.parts.size(), "part"));
      });
  m.def(
      "kept_path", &keep, py::arg("index"), py::arg("clearance"), py::arg("start") = py::none(),
      py::arg("goal") = py::none(),
      "The KeptPath of a PassageIndex: an end nearer to walls is left, or entered, by the shortest way that keeps what "
      "the end has (docs/definitions.md). None where gates are too narrow. Raises InputError.");
}

struct Way {
  FreeSpace space;
  Point start, goal;
  Alternative way;
};

std::vector<Way> ways(const FreeSpace& space, std::size_t count, const std::optional<Point>& start, const Goal& goal) {
  require_point_robot(space);
  if (count == 0) throw py::value_error("count: 1 or more");
  const auto [from, to] = ends_of(space, start, goal);
  const py::gil_scoped_release unlocked;
  const Alternatives found = alternatives(Gates(space), from, to, {.count = count, .most_expanded = 5'000'000});
  if (found.status == SearchStatus::stopped) throw Unproven("too many ways for so many alternatives");
  std::vector<Way> all;
  for (const Alternative& way : found.ways) all.push_back({space, from, to, way});
  return all;
}

void bind_ways(py::module_& m) {
  py::class_<Way>(m, "Alternative", "The shortest path of one way around the obstacles.")
      .def_property_readonly(
          "length", [](const Way& w) { return w.way.path.length.value(); }, "The double nearest to the exact one.")
      .def_property_readonly(
          "points", [](const py::object& self) { return points_view(self.cast<const Way&>().way.path.points, self); },
          "(n, 2): the ends, and the corners that it bends around.")
      .def_property_readonly(
          "width", [](const Way& w) { return w.way.gate ? std::optional(w.way.gate->width) : std::nullopt; },
          "Of the narrowest gate that all paths of this way pass: no larger disc gets along. None: it passes none.")
      .def_property_readonly(
          "gate",
          [](const Way& w) -> py::object {
            if (!w.way.gate) return py::none();
            return py::make_tuple(w.way.gate->at.a, w.way.gate->at.b);
          },
          "That gate's two ends.")
      .def(
          "_repr_svg_",
          [](const Way& w) {
            AlternativesAnswer answer{.start = w.start, .goal = w.goal, .asked = 1};
            answer.found.ways = {w.way};
            return alternatives_svg(answer, w.space, title_of(w.space.world().source()));
          },
          Unlocked())
      .def("__repr__", [](const Way& w) {
        return fmt::format("<taut.Alternative length {}{}>", length_text(w.way.path.length),
                           w.way.gate ? fmt::format(", {:.6g} wide", w.way.gate->width) : "");
      });
  m.def(
      "alternatives", &ways, py::arg("space"), py::arg("count") = 3, py::arg("start") = py::none(),
      py::arg("goal") = py::none(),
      "Up to count Alternatives, the shortest of each homotopy class, the shortest first; none when there is no path. "
      "Raises InputError, Unproven.");
}

}  // namespace

void bind_passage_index(py::module_& m) {
  bind_index(m);
  bind_kept(m);
  bind_ways(m);
}

}  // namespace taut::python
