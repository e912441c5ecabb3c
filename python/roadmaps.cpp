#include <fmt/format.h>

#include <cmath>

#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>
#include <taut/python/answers.h>
#include <taut/python/wishes.h>
#include <taut/search/roadmap_distances.h>

namespace taut::python {

namespace {

/// A roadmap of a kind, ready to be asked.
struct Built {
  FreeSpace space;
  const RoadmapKind* kind;
  PlannedRoadmap planned;

  const Roadmap& graph() const { return *planned.roadmap; }
  std::size_t vertex_count() const { return graph().vertex_count(); }
};

// The first of all rows' targets, which lie one after the other.
const Roadmap::Vertex* first_target(const Roadmap& graph) {
  return graph.vertex_count() == 0 ? nullptr : graph.neighbours(0).data();
}

py::array offsets_of(const Built& built) {
  std::vector<std::int64_t> offsets{0};
  for (std::size_t v = 0; v < built.vertex_count(); ++v)
    offsets.push_back(offsets.back() +
                      static_cast<std::int64_t>(built.graph().neighbours(static_cast<Roadmap::Vertex>(v)).size()));
  return moved(std::move(offsets));
}

py::array edges_of(const Built& built) {
  std::vector<Roadmap::Vertex> edges;
  edges.reserve(2 * built.graph().edge_count());
  for (Roadmap::Vertex v = 0; v < built.vertex_count(); ++v)
    for (const Roadmap::Vertex w : built.graph().neighbours(v))
      if (v < w) edges.insert(edges.end(), {v, w});
  return moved(std::move(edges), {static_cast<py::ssize_t>(built.graph().edge_count()), 2});
}

py::array lengths_of(const Built& built) {
  std::vector<double> lengths;
  lengths.reserve(built.graph().edge_count());
  for (Roadmap::Vertex v = 0; v < built.vertex_count(); ++v)
    for (const Roadmap::Vertex w : built.graph().neighbours(v)) {
      const Point a = built.graph().point(v), b = built.graph().point(w);
      if (v < w) lengths.push_back(std::hypot(b.x - a.x, b.y - a.y));
    }
  return moved(std::move(lengths));
}

std::string doubt(const Built& built) {
  if (built.kind->optimal) return unproven_text(built.space);
  return fmt::format("no path in the roadmap {}, which does not prove that there is none", built.kind->name);
}

std::optional<FoundPath> search(const Built& built, Point from, const Goal& to, GraphMethod method) {
  require_ends(built.space, from, to);
  GraphSearchResult found = about(built.space.world().source(), [&] { return built.planned.search(from, to, method); });
  if (found.status == SearchStatus::found)
    return FoundPath{built.space,
                     from,
                     to,
                     std::move(found.path),
                     built.kind->optimal && found.optimal,
                     within_of(built.space),
                     built.kind->name,
                     found.expanded};
  if (!apart(built.space, from, to)) throw Unproven(doubt(built));
  return std::nullopt;
}

std::optional<FoundPath> find(const Built& built, const std::optional<Point>& start, const Goal& goal,
                              const std::string& algorithm, const std::string& heuristic) {
  const GraphMethod method = method_of(algorithm, heuristic);
  const World& world = built.space.world();
  const Point from = start_of(world, start);
  const Goal to = goal_of_query(world, goal);
  const py::gil_scoped_release unlocked;
  return search(built, from, to, method);
}

// How `place` joins the graph: the nearer a vertex, the shorter its leg.
std::vector<RoadmapSource> sources_of(const Built& built, Point place) {
  if (!built.planned.query)
    throw py::value_error(std::string("a roadmap of the kind '") + built.kind->name + "' is no plain graph");
  require_ends(built.space, place, Goal{place, {}});
  std::vector<RoadmapSource> sources;
  for (const Roadmap::Vertex v : built.planned.query(place, {place, {}}).start.vertices) {
    const Point at = built.graph().point(v);
    sources.push_back({v, std::hypot(at.x - place.x, at.y - place.y)});
  }
  return sources;
}

py::tuple distances_to(const Built& built, Point place) {
  RoadmapDistances distances;
  {
    const py::gil_scoped_release unlocked;
    distances = roadmap_distances(built.graph(), sources_of(built, place));
  }
  std::vector<std::int64_t> next;
  for (const Roadmap::Vertex v : distances.next) next.push_back(v == kNone ? -1 : static_cast<std::int64_t>(v));
  return py::make_tuple(moved(std::move(distances.length)), moved(std::move(next)));
}

std::string picture(const Built& built) {
  const World& world = built.space.world();
  return svg(built.space, {.title = title_of(world.source()),
                           .facts = {built.kind->title, count_text(built.vertex_count(), "vertex", "vertices"),
                                     count_text(built.graph().edge_count(), "edge")},
                           .roadmap = &built.graph(),
                           .start = world.start(),
                           .goal = world.goal(),
                           .milestones = built.kind->samples});
}

Built build(const FreeSpace& space, const std::string& word, const std::optional<Point>& start, const Goal& goal,
            const py::kwargs& wishes) {
  const RoadmapKind& kind = kind_named(word);
  if (!kind.graph) throw py::value_error("kind: '" + word + "' makes no graph");
  BuildRequest request = request_of(wishes);
  const World& world = space.world();
  const Goal& to = goal.point || !goal.room.empty() ? goal : world.goal();
  request.from = start ? start : world.start();
  request.to = to;
  const py::gil_scoped_release unlocked;
  if (request.from && (to.point || !to.room.empty())) require_ends(space, *request.from, to);
  return {space, &kind, about(world.source(), [&] { return kind.build(space, request); })};
}

py::dict kinds() {
  py::dict all;
  for (const RoadmapKind& kind : roadmap_kinds())
    if (kind.graph) all[kind.name] = kind.what;
  return all;
}

void bind_arrays(py::class_<Built>& roadmap) {
  roadmap
      .def_property_readonly(
          "points",
          [](const py::object& self) { return points_view(self.cast<const Built&>().graph().points(), self); },
          "(v, 2): the vertices.")
      .def_property_readonly("edges", &edges_of, "(e, 2) uint32: the edges, each once, the lower vertex first.")
      .def_property_readonly("lengths", &lengths_of, "(e,): of the edges.")
      .def_property_readonly("offsets", &offsets_of,
                             "(v + 1,): the neighbours of v are targets[offsets[v]:offsets[v + 1]].")
      .def_property_readonly(
          "targets",
          [](const py::object& self) {
            const Roadmap& graph = self.cast<const Built&>().graph();
            return view(first_target(graph), {static_cast<py::ssize_t>(2 * graph.edge_count())}, self);
          },
          "(2 e,) uint32: every edge from both ends, rows ascending.");
}

}  // namespace

void bind_roadmaps(py::module_& m) {
  py::class_<Built> roadmap(m, "Roadmap", "A graph embedded in a FreeSpace.");
  bind_arrays(roadmap);
  roadmap.def_readonly("space", &Built::space)
      .def_property_readonly("kind", [](const Built& b) { return b.kind->name; })
      .def_property_readonly(
          "optimal", [](const Built& b) { return b.kind->optimal; }, "Its paths are the shortest in the plane.")
      .def("find", &find, py::arg("start") = py::none(), py::arg("goal") = py::none(), py::kw_only(),
           py::arg("algorithm") = "astar", py::arg("heuristic") = "euclidean",
           "A Path in the roadmap, by 'astar', 'dijkstra', 'bfs', 'dfs' or 'greedy'; the estimate is 'euclidean', "
           "'manhattan', 'octile', 'chebyshev' or 'zero'. None when there is none anywhere, proven. Raises Unproven "
           "where only the roadmap has none, InputError.")
      .def("distances_to", &distances_to, py::arg("point"),
           "length (v,): of each vertex' way to the point, inf where there is none, off by at most an ulp a leg; next "
           "(v,): the vertex to go to, -1 where it is the point itself or there is no way.")
      .def("__len__", &Built::vertex_count)
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", [](const Built& b) {
        return fmt::format("<taut.Roadmap {}: {}, {}>", b.kind->name,
                           count_text(b.vertex_count(), "vertex", "vertices"),
                           count_text(b.graph().edge_count(), "edge"));
      });
  m.def("roadmap", &build, py::arg("space"), py::arg("kind") = "visibility", py::arg("start") = py::none(),
        py::arg("goal") = py::none(),
        (std::string("A Roadmap of one of roadmap_kinds(). A 'prm' grows until it joins start and goal, the world's "
                     "own unless others are given. ") +
         kWishes + " Raises InputError where the world does not suit the kind.")
            .c_str());
  m.def("roadmap_kinds", &kinds, "What roadmaps there are: a line for each name.");
}

}  // namespace taut::python
