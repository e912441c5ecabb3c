#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include <taut/geometry/rounding.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/words.h>
#include <taut/io/saved/all_radii_file.h>
#include <taut/python/answers.h>
#include <taut/python/wishes.h>
#include <taut/roadmaps/all_radii.h>
#include <taut/roadmaps/tangent_graph.h>
#include <taut/search/arc_search.h>
#include <taut/search/passage.h>
#include <taut/search/query_ends.h>
#include <taut/search/radius_queries.h>
#include <taut/search/verify_arcs.h>
#include <taut/search/voronoi_search.h>

namespace taut::python {

namespace {

// ---- passages -------------------------------------------------------------------------------------------------------

py::array gates_array(const Gates& gates) {
  std::vector<Segment> segments;
  for (const Gate& gate : gates.gates()) segments.push_back({gate.end, gate.foot});
  return segments_array(segments);
}

py::array widths_array(const Gates& gates) {
  std::vector<double> widths;
  for (const Gate& gate : gates.gates()) widths.push_back(gate.width);
  return moved(std::move(widths));
}

Passage passage_of(const Gates& gates, const std::optional<Point>& start, const Goal& goal,
                   std::optional<double> radius) {
  const World& world = gates.space().world();
  const Point from = start_of(world, start);
  const Goal to = goal_of_query(world, goal);
  if (radius) require_radius(*radius);
  const py::gil_scoped_release unlocked;
  require_ends(gates.space(), from, to);
  const std::vector<Point> goals = goal_points(gates.space(), to);
  if (goals.empty()) throw Refusal(InputError("", 0, "the middles of the goal room are no free places"), "");
  return passage(gates, from, goals, radius);
}

py::tuple barrier_gates(const Passage& p) {
  std::vector<double> widths;
  for (const NamedGate& gate : p.barrier.gates) widths.push_back(gate.width);
  return py::make_tuple(segments_array(p.barrier.gate_segments()), moved(std::move(widths)));
}

std::string repr(const Passage& p) {
  const std::string widest = p.widest ? "radius " + number_text(p.widest->radius) : "not even a point";
  return fmt::format("<taut.Passage: {} gets through>", widest);
}

void bind_passages(py::module_& m) {
  py::class_<Passage>(m, "Passage", "How large a disc gets through, and what stops a larger one.")
      .def_property_readonly(
          "radius", [](const Passage& p) { return p.widest ? std::optional(p.widest->radius) : std::nullopt; },
          "Of the largest disc that gets through, exactly: no larger double does. None: not even a point does.")
      .def_property_readonly("gets_through", &Passage::gets_through,
                             "Of the radius that was asked about; without one, of a point.")
      .def_property_readonly("is_proven", &Passage::is_proven)
      .def_property_readonly(
          "walls", [](const Passage& p) { return segments_array(p.barrier.walls); },
          "(n, 4): the walls of the chain that stops the disc asked about, else any larger one.")
      .def_property_readonly("gates", &barrier_gates, "(n, 4), (n,): its gates, the widest first, and their widths.")
      .def_readonly("start", &Passage::start)
      .def_readonly("goal", &Passage::goal)
      .def("__bool__", &Passage::gets_through)
      .def("__repr__", &repr);
  py::class_<Gates>(m, "Gates", "Where walls come near each other: what a disc has to pass. Of a point's space.")
      .def(py::init([](const FreeSpace& space) {
             require_point_robot(space);
             const py::gil_scoped_release unlocked;
             return Gates(space);
           }),
           py::arg("space"))
      .def_property_readonly("segments", &gates_array, "(n, 4): narrowest first, to the nearest doubles.")
      .def_property_readonly("widths", &widths_array, "(n,): the diameters that pass.")
      .def("__len__", [](const Gates& g) { return g.gates().size(); })
      .def("passage", &passage_of, py::arg("start") = py::none(), py::arg("goal") = py::none(),
           py::arg("radius") = py::none(), "A Passage from start to goal. Raises InputError when an end is not free.");
}

// ---- paths of arcs --------------------------------------------------------------------------------------------------

struct Rounded {
  FreeSpace space;
  ArcPath path;
  double within = 0;
};

void require_places(const ArcSearchResult& found, const FreeSpace& space, double r, Point from, Point to) {
  if (found.status != DiscStatus::start_blocked && found.status != DiscStatus::goal_blocked) return;
  about(space.world().source(), [&] {
    const DiscPlaces places(space, r);
    require_free(places, from, "start");
    require_free(places, to, "goal");
  });
}

/// What `search` finds, of a disc that can be at both ends.
template <class Search>
std::optional<Rounded> found_path(const FreeSpace& space, double r, const std::optional<Point>& start, const Goal& goal,
                                  Search search) {
  require_radius(r);
  const Point from = start_of(space.world(), start);
  const Goal to = goal_of_query(space.world(), goal);
  if (!to.point) throw InputError("", 0, "the goal of a disc is a point");
  const py::gil_scoped_release unlocked;
  require_ends(space, from, to);
  ArcSearchResult found = search(from, *to.point);
  require_places(found, space, r, from, *to.point);
  if (found.status == DiscStatus::found) return Rounded{space, std::move(found.path), rounding_bound(space)};
  const DiscPassage passage = disc_passage(space, from, *to.point, r);
  if (passage.status != DiscStatus::none)
    throw Unproven("no path found, but no walls and gaps that prove that there is none");
  return std::nullopt;
}

std::optional<Rounded> disc_path(const FreeSpace& space, double r, const std::optional<Point>& start,
                                 const Goal& goal) {
  require_point_robot(space);
  return found_path(space, r, start, goal,
                    [&](Point from, Point to) { return arc_search(TangentGraph(space, r), from, to); });
}

std::vector<Point> points(const ArcPath& path, std::optional<double> tolerance) {
  if (tolerance && !(*tolerance > 0)) throw py::value_error("tolerance: above 0");
  return sampled(path, tolerance.value_or(path.radius / 1000));
}

std::string picture(const Rounded& r) {
  return svg(r.space, {.title = title_of(r.space.world().source()),
                       .facts = {"length " + plain_length(r.path.value())},
                       .start = r.path.start,
                       .goal = Goal{r.path.goal, {}},
                       .arcs = &r.path});
}

void bind_arcs(py::module_& m) {
  py::class_<Rounded>(m, "ArcPath", "The path of a disc's centre: straight legs, and arcs around corners.")
      .def_property_readonly("length", [](const Rounded& r) { return r.path.value(); })
      .def_property_readonly(
          "length_bounds", [](const Rounded& r) { return py::make_tuple(r.path.length.lo, r.path.length.hi); },
          "Two doubles around the exact length.")
      .def_property_readonly("radius", [](const Rounded& r) { return r.path.radius; })
      .def_readonly("within", &Rounded::within)
      .def_property_readonly(
          "points", [](const Rounded& r) { return points_array(points(r.path, std::nullopt)); },
          "(n, 2): on the path, legs between them no farther from it than radius / 1000.")
      .def(
          "sampled", [](const Rounded& r, double tolerance) { return points_array(points(r.path, tolerance)); },
          py::arg("tolerance"), "(n, 2): on the path, legs between them no farther from it than that.")
      .def(
          "verify",
          [](const Rounded& r) {
            const py::gil_scoped_release unlocked;
            return verify_arcs(r.path, Gates(r.space), r.path.start, r.path.goal).valid;
          },
          "A check that shares nothing with the planner: True when it can be followed.")
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", [](const Rounded& r) {
        return fmt::format("<taut.ArcPath length {}, {}>", plain_length(r.path.value()),
                           count_text(r.path.bends.size(), "bend"));
      });
  m.def("disc_path", &disc_path, py::arg("space"), py::arg("radius"), py::arg("start") = py::none(),
        py::arg("goal") = py::none(),
        "The shortest ArcPath of a disc of exactly that radius, in a point's space; None when there is none, proven. "
        "Raises InputError when the disc cannot be at an end, Unproven.");
}

// ---- all radii ------------------------------------------------------------------------------------------------------

/// One query at a time.
class RadiusAsker {
 public:
  explicit RadiusAsker(AllRadii all) : queries_(std::move(all)), lock_(std::make_unique<std::mutex>()) {}

  const AllRadii& all() const { return queries_.all(); }

  ArcSearchResult find(double r, Point from, Point to) {
    const std::lock_guard guard(*lock_);
    return queries_.find(r, from, to);
  }

  std::size_t graphs() const {
    const std::lock_guard guard(*lock_);
    return queries_.graphs_made();
  }

 private:
  RadiusQueries queries_;
  std::unique_ptr<std::mutex> lock_;
};

RadiusAsker asker_of(const FreeSpace& space) {
  require_point_robot(space);
  const py::gil_scoped_release unlocked;
  return RadiusAsker(AllRadii(space));
}

py::array lengths_of(RadiusAsker& asker, py::handle queries) {
  const Doubles rows = rows_of(queries, 5, "queries: rows sx, sy, gx, gy, radius");
  std::vector<double> lengths(static_cast<std::size_t>(rows.shape(0)), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < lengths.size(); ++i) require_radius(rows.at(static_cast<py::ssize_t>(i), 4));
  {
    const py::gil_scoped_release unlocked;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const double* row = rows.data(static_cast<py::ssize_t>(i), 0);
      const ArcSearchResult found = asker.find(row[4], {row[0], row[1]}, {row[2], row[3]});
      if (found.status == DiscStatus::found) lengths[i] = found.path.value();
    }
  }
  return moved(std::move(lengths));
}

void bind_radii(py::module_& m) {
  py::class_<RadiusAsker>(m, "AllRadii",
                          "Paths of discs of any radius, from one index: what is the same for all radii is found once. "
                          "A radius asked about twice gets a graph; the last 16 are kept. Of a point's space.")
      .def(py::init(&asker_of), py::arg("space"))
      .def(
          "path",
          [](RadiusAsker& asker, double r, const std::optional<Point>& start, const Goal& goal) {
            return found_path(asker.all().space(), r, start, goal,
                              [&](Point from, Point to) { return asker.find(r, from, to); });
          },
          py::arg("radius"), py::arg("start") = py::none(), py::arg("goal") = py::none(),
          "As disc_path: the first query of a radius in about a millisecond, without a graph of that radius; from the "
          "third one on in microseconds.")
      .def(
          "lengths", &lengths_of, py::arg("queries"),
          "(n,) of (n, 5) rows sx, sy, gx, gy, radius: the shortest paths' lengths; nan where there is none, or an end "
          "is no place for the disc.")
      .def(
          "to_bytes",
          [](const RadiusAsker& asker) {
            std::string bytes;
            {
              const py::gil_scoped_release unlocked;
              bytes = all_radii_file(asker.all());
            }
            return py::bytes(bytes);
          },
          "To be kept; a mark of the world goes along.")
      .def_static(
          "from_bytes",
          [](const py::bytes& bytes, const FreeSpace& space) {
            require_point_robot(space);
            const std::string text = bytes;
            const py::gil_scoped_release unlocked;
            return RadiusAsker(read_all_radii(text, "bytes", space));
          },
          py::arg("bytes"), py::arg("space"),
          "What to_bytes gave, for a space of the same world. Raises InputError when it is of another, or damaged.")
      .def_property_readonly("graphs", &RadiusAsker::graphs, Unlocked(),
                             "How many graphs of a radius were made: none for the first query of a radius.")
      .def(
          "__len__", [](const RadiusAsker& asker) { return asker.all().leg_count(); },
          "Straight legs that are or may be free for some radius.");
}

}  // namespace

void bind_discs(py::module_& m) {
  bind_passages(m);
  bind_arcs(m);
  bind_radii(m);
}

}  // namespace taut::python
