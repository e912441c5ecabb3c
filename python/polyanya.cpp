#include <fmt/format.h>

#include <taut/geometry/parallel.h>
#include <taut/python/asker.h>
#include <taut/search/shortest_path.h>

namespace taut::python {

namespace {

std::vector<Ends> queries_of(const py::object& given) {
  const Doubles rows = rows_of(given, 4, "queries");
  std::vector<Ends> queries;
  queries.reserve(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const double* row = rows.data(i, 0);
    queries.push_back({{row[0], row[1]}, {row[2], row[3]}});
    if (!is_in_reach(queries.back().first) || !is_in_reach(queries.back().second))
      throw InputError("", 0, fmt::format("queries: row {} holds what is no coordinate", i));
  }
  return queries;
}

std::vector<Point> goals_of(const py::object& given) {
  std::vector<Point> goals = points_of(given, "goals");
  for (const Point p : goals)
    if (!is_in_reach(p)) throw InputError("", 0, fmt::format("goals: ({}, {}) is not a point", p.x, p.y));
  return goals;
}

// `work` without the lock; now and then it asks whether to end, which Ctrl-C says.
template <class Work>
auto interruptible(const Work& work) {
  bool is_over = false;
  const auto ask = [&is_over] {
    const py::gil_scoped_acquire locked;
    return is_over = is_over || PyErr_CheckSignals() != 0;
  };
  auto result = [&] {
    const py::gil_scoped_release unlocked;
    return work(ask);
  }();
  if (is_over) throw py::error_already_set();
  return result;
}

unsigned thread_count(unsigned asked) { return asked > 0 ? asked : core_count(); }

Answers many(const Asker& asker, const py::object& given, bool with_paths, unsigned threads) {
  const std::vector<Ends> queries = queries_of(given);
  return interruptible(
      [&](const auto& ask) { return asker.find_many(queries, with_paths, thread_count(threads), ask); });
}

py::array matrix(const Asker& asker, const py::object& given_starts, const py::object& given_goals, unsigned threads) {
  const std::vector<Point> starts = goals_of(given_starts);
  const std::vector<Point> goals = given_goals.is_none() ? starts : goals_of(given_goals);
  std::vector<double> lengths =
      interruptible([&](const auto& ask) { return asker.distances(starts, goals, thread_count(threads), ask); });
  return moved(std::move(lengths), {static_cast<py::ssize_t>(starts.size()), static_cast<py::ssize_t>(goals.size())});
}

std::optional<FoundPath> one(const World& world, const std::optional<Point>& start, const Goal& goal,
                             const Footprint& footprint) {
  const Point from = start_of(world, start);
  const Goal to = goal_of_query(world, goal);
  const py::gil_scoped_release unlocked;
  const FreeSpace space = about(world.source(), [&] { return FreeSpace(world.with_ends(from, to.point), footprint); });
  return Asker(Polyanya::between(space, from, to)).find(from, to);
}

std::optional<FoundPath> one_in_space(const FreeSpace& space, const std::optional<Point>& start, const Goal& goal) {
  const Point from = start_of(space.world(), start);
  const Goal to = goal_of_query(space.world(), goal);
  const py::gil_scoped_release unlocked;
  return Asker(Polyanya(space)).find(from, to);
}

Asker made(const FreeSpace& space, std::size_t landmarks) {
  const Polyanya polyanya(space);
  return Asker(landmarks == 0 ? polyanya : polyanya.with_landmarks(landmarks));
}

/// An array of the numbers that `owner` keeps.
template <typename Number>
py::object view_of(const std::vector<Number>& numbers, const py::object& owner) {
  return view(numbers.data(), {static_cast<py::ssize_t>(numbers.size())}, owner);
}

void bind_answers(py::module_& m) {
  py::class_<Answers>(m, "Answers", "Answers to many queries, in their order.")
      .def_property_readonly(
          "status", [](const py::object& self) { return view_of(self.cast<const Answers&>().status, self); },
          "(n,) uint8: 0 found, 1 none (proven), 2 an end is not free, 3 unproven.")
      .def_property_readonly(
          "length", [](const py::object& self) { return view_of(self.cast<const Answers&>().length, self); },
          "(n,): to the nearest double; inf where there is no path, nan where that or the ends are in doubt.")
      .def_property_readonly(
          "offsets", [](const py::object& self) { return view_of(self.cast<const Answers&>().offsets, self); },
          "(n + 1,): of path i the points offsets[i] to offsets[i + 1]; empty without paths.")
      .def_property_readonly(
          "points", [](const py::object& self) { return points_view(self.cast<const Answers&>().points, self); },
          "(m, 2): of all paths, one after the other.")
      .def("__len__", [](const Answers& a) { return a.status.size(); })
      .def(
          "path",
          [](const py::object& self, std::size_t i) {
            const Answers& a = self.cast<const Answers&>();
            if (i + 1 >= a.offsets.size())
              throw py::index_error(a.offsets.empty() ? "ask with paths=True" : "no such query");
            const auto first = static_cast<std::size_t>(a.offsets[i]),
                       last = static_cast<std::size_t>(a.offsets[i + 1]);
            return points_view(std::span(a.points).subspan(first, last - first), self);
          },
          py::arg("i"), "(k, 2): the points of path i; none where there is no path.");
}

}  // namespace

void bind_polyanya(py::module_& m) {
  bind_answers(m);
  py::class_<Asker>(m, "Polyanya",
                    "A free space with its navigation mesh, for any number of queries and threads. landmarks: a table "
                    "of distances from so many places, for thousands of queries where paths wind.")
      .def(py::init(&made), Unlocked(), py::arg("space"), py::arg("landmarks") = 0)
      .def_property_readonly("space", &Asker::space, py::return_value_policy::copy)
      .def(
          "find",
          [](const Asker& asker, Point start, const Goal& goal) {
            const py::gil_scoped_release unlocked;
            return asker.find(start, goal);
          },
          py::arg("start"), py::arg("goal"),
          "The shortest Path; None when there is none, proven. The goal is a point, or a room as boxes (n, 4). Raises "
          "InputError when an end is not free, Unproven.")
      .def("find_many", &many, py::arg("queries"), py::kw_only(), py::arg("paths") = false, py::arg("threads") = 0,
           "Answers to queries (n, 4): start x y, goal x y. On all cores, or so many threads, without Python's lock; "
           "the answers are the same however many. paths: their points as well. Ctrl-C stops it.")
      .def("distances", &matrix, py::arg("starts"), py::arg("goals") = py::none(), py::kw_only(),
           py::arg("threads") = 0,
           "(n, m): the lengths of the shortest paths from starts (n, 2) to goals (m, 2), the starts themselves unless "
           "given; inf where there is no path, nan where that is in doubt or an end is not free. One search a start, "
           "on all cores.")
      .def(
          "find_nearest",
          [](const Asker& asker, Point start, const py::object& goals) {
            const std::vector<Point> points = goals_of(goals);
            const py::gil_scoped_release unlocked;
            return asker.find_nearest(start, points);
          },
          py::arg("start"), py::arg("goals"),
          "The shortest Path to any of the goals (n, 2) and which one it is; None when none is reached. Goals that are "
          "not free are left out.")
      .def(
          "find_each",
          [](const Asker& asker, Point start, const py::object& goals) {
            const std::vector<Point> points = goals_of(goals);
            const py::gil_scoped_release unlocked;
            return asker.find_each(start, points);
          },
          py::arg("start"), py::arg("goals"),
          "A list of the shortest Path to each of the goals (n, 2), in one search; None where there is none.");
  m.def("shortest_path", &one, py::arg("world"), py::arg("start") = py::none(), py::arg("goal") = py::none(),
        py::arg("footprint") = Footprint::point(),
        "The shortest Path in a World, or a FreeSpace, from start to goal, its own unless others are given; None when "
        "there is none, proven: no_path says why. Raises InputError when an end is not free, Unproven.");
  m.def("shortest_path", &one_in_space, py::arg("space"), py::arg("start") = py::none(), py::arg("goal") = py::none());
}

}  // namespace taut::python
