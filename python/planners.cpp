#include <taut/python/answers.h>
#include <taut/python/wishes.h>
#include <taut/search/planners.h>

namespace taut::python {

namespace {

const Planner& planner_named(const std::string& word) {
  const Planner* found = planner(word);
  if (!found) throw py::value_error("planner: " + planner_names() + ", not '" + word + "'");
  return *found;
}

py::dict names() {
  py::dict all;
  for (const Planner& p : planners()) all[p.name] = p.what;
  return all;
}

std::optional<FoundPath> plan(const FreeSpace& space, const std::string& word, const std::optional<Point>& start,
                              const Goal& goal, const py::kwargs& wishes) {
  const Planner& chosen = planner_named(word);
  const BuildRequest request = request_of(wishes);
  const Point from = start_of(space.world(), start);
  const Goal to = goal_of_query(space.world(), goal);
  const py::gil_scoped_release unlocked;
  require_ends(space, from, to);
  PlannerRuns runs = run_planner(chosen, space, from, to, request.seed, 1, request);
  if (runs.runs.empty()) throw Refusal(InputError("", 0, runs.unfit), space.world().source());
  PlannerRun& run = runs.runs.front();
  if (run.solved)
    return FoundPath{space, from, to, std::move(run.path), runs.optimal, within_of(space), chosen.name, run.expanded};
  if (!apart(space, from, to))
    throw Unproven(std::string("the planner ") + chosen.name +
                   " found no path, which does not prove that there is none");
  return std::nullopt;
}

py::dict row_of(const PlannerRuns& runs, const PlannerRun& run, std::uint64_t seed, const std::optional<Length>& best) {
  const double length = run.path.length.value();
  py::dict row;
  row["planner"] = runs.planner->name;
  row["seed"] = seed;
  row["solved"] = run.solved;
  row["length"] = run.solved ? py::object(py::float_(length)) : py::none();
  row["ratio"] =
      run.solved && best ? py::object(py::float_(best->value() > 0 ? length / best->value() : 1)) : py::none();
  row["clearance"] = run.clearance ? py::object(py::float_(*run.clearance)) : py::none();
  row["verified"] = run.verified;
  row["vertices"] = run.vertices;
  row["edges"] = run.edges;
  row["expanded"] = run.expanded;
  row["build_seconds"] = run.build.cpu;
  row["query_seconds"] = run.query.cpu;
  row["unfit"] = runs.unfit;
  return row;
}

std::vector<const Planner*> chosen_planners(const py::object& given, const FreeSpace& space) {
  std::vector<const Planner*> chosen;
  if (!given.is_none())
    for (const py::handle word : given) chosen.push_back(&planner_named(word.cast<std::string>()));
  else
    for (const Planner& p : planners())
      if (too_large(p, space).empty()) chosen.push_back(&p);
  return chosen;
}

py::list compare(const FreeSpace& space, const py::object& given, const std::optional<Point>& start, const Goal& goal,
                 std::size_t runs, const py::kwargs& wishes) {
  if (py::isinstance<py::str>(given)) throw py::type_error("planners: a list of names");
  if (runs == 0) throw py::value_error("runs: at least 1");
  const std::vector<const Planner*> chosen = chosen_planners(given, space);
  const BuildRequest request = request_of(wishes);
  Comparison comparison{start_of(space.world(), start), goal_of_query(space.world(), goal), request.seed, runs};
  {
    const py::gil_scoped_release unlocked;
    require_ends(space, comparison.start, comparison.goal);
    for (const Planner* p : chosen)
      comparison.add(run_planner(*p, space, comparison.start, comparison.goal, request.seed, runs, request));
  }
  py::list table;
  for (const PlannerRuns& all : comparison.planners) {
    if (all.runs.empty()) table.append(row_of(all, {}, request.seed, comparison.optimum));
    for (std::size_t i = 0; i < all.runs.size(); ++i)
      table.append(row_of(all, all.runs[i], request.seed + i, comparison.optimum));
  }
  return table;
}

}  // namespace

void bind_planners(py::module_& m) {
  m.def("planners", &names, "What planners there are: a line for each name.");
  m.def("plan", &plan, py::arg("space"), py::arg("planner") = "polyanya", py::arg("start") = py::none(),
        py::arg("goal") = py::none(),
        (std::string("A Path by one of planners(); None when there is none, proven. ") + kWishes +
         " Raises InputError when an end is not free or the world does not suit the planner, Unproven.")
            .c_str());
  m.def("compare", &compare, py::arg("space"), py::arg("planners") = py::none(), py::arg("start") = py::none(),
        py::arg("goal") = py::none(), py::arg("runs") = 1,
        (std::string("A table, for pandas.DataFrame: a dict for each run of each planner; random ones run with seeds "
                     "seed, seed + 1, ... `ratio` is to the shortest in the plane, seconds are CPU, `unfit` says why a "
                     "planner did not run at all. ") +
         kWishes)
            .c_str());
}

}  // namespace taut::python
