// Our planners and OMPL's on the same mazes, in the same run, in CPU time; bench/README.md says how to read it.
//
// First table: every planner is asked for its first path, and every motion is tested by FreeSpace::sees, exactly. Second table: OMPL as it comes out of
// the box, with motions sampled at its default resolution, and what an exact check says of its answers.
//
//   ompl_bench [--benchmark_filter=REGEX] [--sides=7,15,25,41,61] [--seeds=3] [--limit=10] [--audits=20]
//
// The filter is for planner names. --limit is CPU seconds for one run; who fails all runs of a size is not asked for larger ones.
#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <taut/geometry/maze_generator.h>
#include <taut/geometry/predicates.h>
#include <taut/search/funnel.h>
#include <taut/search/prm_planner.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

namespace {

using namespace taut;
namespace ob = ompl::base;
namespace og = ompl::geometric;

struct Settings {
  std::regex filter{"."};
  std::vector<int> sides{7, 15, 25, 41, 61};
  int seeds = 3;
  double limit = 10;
  int audits = 20;
};

/// Of the whole process: OMPL's PRM has a second thread that looks for solutions.
double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

struct Task {
  FreeSpace space;
  Point from;
  Goal to;
  Path optimum;

  explicit Task(FreeSpace free_space)
      : space(std::move(free_space)), from(*space.world().start()), to(space.world().goal()) {
    optimum = *shortest_path(space, from, to);
  }
};

struct Run {
  bool found = false;
  double seconds = 0;
  Path path{};
  double vertices = 0, edges = 0;
};

struct Row {
  std::string name;
  std::function<Run(const Task&, std::uint64_t seed, double limit)> run;
  int largest = 1'000'000;  // side
};

// ---- ours ---------------------------------------------------------------------------------------------------------------------------

Run our_prm(const Task& task, std::uint64_t seed, double limit, PrmConnection::Rule rule, bool pull) {
  PrmPlan plan;
  plan.roadmap.seed = seed;
  plan.roadmap.connection.rule = rule;
  plan.seconds = limit;
  const double begin = cpu_seconds();
  PrmResult result = prm_path(task.space, task.from, task.to, plan);
  Run run{result.search.status == SearchStatus::found, 0, std::move(result.search.path)};
  if (run.found && pull) run.path = *shortened(task.space, run.path);
  run.seconds = cpu_seconds() - begin;
  run.vertices = static_cast<double>(result.counts.kept);
  run.edges = static_cast<double>(result.counts.edges);
  return run;
}

Run our_exact(const Task& task) {
  const double begin = cpu_seconds();
  const VisibilityGraph graph(task.space);
  GraphSearchResult result = shortest_path(graph, task.from, task.to);
  return {result.status == SearchStatus::found, cpu_seconds() - begin, std::move(result.path),
          static_cast<double>(graph.roadmap().vertex_count()), static_cast<double>(graph.roadmap().edge_count())};
}

// ---- OMPL ---------------------------------------------------------------------------------------------------------------------------

Point point_of(const ob::State* state) {
  const auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

class ExactMotions : public ob::MotionValidator {
 public:
  ExactMotions(const ob::SpaceInformationPtr& information, const FreeSpace& space)
      : ob::MotionValidator(information), space_(space) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return space_.sees(point_of(a), point_of(b));
  }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last) const override {
    if (checkMotion(a, b)) return true;
    if (last.first != nullptr) si_->copyState(last.first, a);
    last.second = 0;
    return false;
  }

 private:
  const FreeSpace& space_;
};

/// A point in the box of the world; motions exact, or as OMPL has them.
ob::SpaceInformationPtr information_of(const FreeSpace& space, bool exact) {
  const Box box = space.world().box();
  auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  for (const auto& [axis, low, high] : {std::tuple(0u, box.min.x, box.max.x), std::tuple(1u, box.min.y, box.max.y)}) {
    bounds.setLow(axis, low);
    bounds.setHigh(axis, high);
  }
  plane->setBounds(bounds);
  auto information = std::make_shared<ob::SpaceInformation>(plane);
  information->setStateValidityChecker(
      [space](const ob::State* s) { return space.locate(point_of(s)).kind != Location::Kind::outside; });
  if (exact) information->setMotionValidator(std::make_shared<ExactMotions>(information, space));
  information->setup();
  return information;
}

/// The first solution is as good as any.
ob::ProblemDefinitionPtr problem_of(const ob::SpaceInformationPtr& information, const Task& task) {
  auto problem = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<> from(information), to(information);
  from[0] = task.from.x;
  from[1] = task.from.y;
  to[0] = task.to.point->x;
  to[1] = task.to.point->y;
  problem->setStartAndGoalStates(from, to);
  auto length = std::make_shared<ob::PathLengthOptimizationObjective>(information);
  length->setCostThreshold(ob::Cost(std::numeric_limits<double>::infinity()));
  problem->setOptimizationObjective(length);
  return problem;
}

template <class Planner>
Run ompl_run(const Task& task, double limit, bool exact) {
  const auto information = information_of(task.space, exact);
  const auto problem = problem_of(information, task);
  Planner planner(information);
  planner.setProblemDefinition(problem);
  planner.setup();
  const double begin = cpu_seconds();
  planner.solve(ob::PlannerTerminationCondition([&] { return cpu_seconds() - begin > limit; }));
  Run run{problem->hasExactSolution(), cpu_seconds() - begin};
  if (run.found) {
    for (const ob::State* state : problem->getSolutionPath()->as<og::PathGeometric>()->getStates())
      run.path.points.push_back(point_of(state));
    run.path.length = Length(run.path.points);
  }
  ob::PlannerData graph(information);
  planner.getPlannerData(graph);
  run.vertices = graph.numVertices();
  run.edges = graph.numEdges();
  return run;
}

template <class Planner>
Row ompl_row(const char* name, int largest = 1'000'000) {
  return {name, [](const Task& task, std::uint64_t, double limit) { return ompl_run<Planner>(task, limit, true); },
          largest};
}

// ---- tables -------------------------------------------------------------------------------------------------------------------------

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

/// A number of each run, those that found a path.
std::vector<double> of_found(const std::vector<Run>& runs, const std::function<double(const Run&)>& number) {
  std::vector<double> values;
  for (const Run& run : runs)
    if (run.found) values.push_back(number(run));
  return values;
}

std::string ratio_text(const std::vector<Run>& runs, const Length& optimum) {
  const bool all_equal =
      std::all_of(runs.begin(), runs.end(), [&](const Run& run) { return !run.found || run.path.length == optimum; });
  if (all_equal) return "1";  // exactly
  return fmt::format("{:.4f}",
                     median(of_found(runs, [&](const Run& run) { return run.path.length.value() / optimum.value(); })));
}

void require_valid(const Run& run, const Task& task, const std::string& name) {
  if (!run.found) return;
  const Verdict verdict = verify(run.path, task.space, task.from, task.to);
  if (!verdict.valid) fmt::print("ERROR: {} gave a path that is none: {}\n", name, verdict.reason);
  if (run.path.length < task.optimum.length) fmt::print("ERROR: {} is shorter than the shortest path\n", name);
}

FreeSpace maze(int side, const Footprint& robot = Footprint::point()) {
  return FreeSpace(world_of(std::make_shared<GridMaze>(generate_biased_maze(side, side, 1))), robot);
}

void first_paths(const Settings& settings) {
  using Rule = PrmConnection::Rule;
  std::vector<Row> rows{
      {"taut-visibility", [](const Task& task, std::uint64_t, double) { return our_exact(task); }},
      {"taut-prm",
       [](const Task& t, std::uint64_t s, double limit) { return our_prm(t, s, limit, Rule::visible, false); }},
      {"taut-prm-funnel",
       [](const Task& t, std::uint64_t s, double limit) { return our_prm(t, s, limit, Rule::visible, true); }},
      {"taut-forest-funnel",
       [](const Task& t, std::uint64_t s, double limit) { return our_prm(t, s, limit, Rule::forest, true); }},
      ompl_row<og::PRM>("ompl-PRM"),
      ompl_row<og::LazyPRM>("ompl-LazyPRM", 25),  // in larger mazes it looks at no limit for minutes
      ompl_row<og::PRMstar>("ompl-PRMstar"),
      ompl_row<og::RRTConnect>("ompl-RRTConnect"),
      ompl_row<og::BITstar>("ompl-BITstar"),
  };
  std::erase_if(rows, [&](const Row& row) { return !std::regex_search(row.name, settings.filter); });
  fmt::print("{:<20}{:>6}{:>9}{:>12}{:>10}{:>10}{:>10}\n", "planner", "side", "solved", "cpu ms", "length", "vertices",
             "edges");
  for (const int side : settings.sides) {
    const Task task(maze(side));
    for (Row& row : rows) {
      if (!row.run || side > row.largest) continue;
      std::vector<Run> runs;
      for (int seed = 1; seed <= settings.seeds; ++seed) {
        runs.push_back(row.run(task, static_cast<std::uint64_t>(seed), settings.limit));
        require_valid(runs.back(), task, row.name);
      }
      const auto solved = std::count_if(runs.begin(), runs.end(), [](const Run& run) { return run.found; });
      if (solved == 0) row.run = nullptr;
      const auto middle = [&](auto number) { return median(of_found(runs, number)); };
      fmt::print("{:<20}{:>6}{:>9}{:>12}{:>10}{:>10.0f}{:>10.0f}\n", row.name, side,
                 fmt::format("{}/{}", solved, runs.size()),
                 solved ? fmt::format("{:.2f}", 1e3 * middle([](const Run& run) { return run.seconds; })) : "-",
                 solved ? ratio_text(runs, task.optimum.length) : "-",
                 middle([](const Run& run) { return run.vertices; }), middle([](const Run& run) { return run.edges; }));
      std::fflush(stdout);
    }
  }
}

/// Walls, and not their ends, that the path goes through.
std::size_t walls_crossed(const Path& path, const World& world) {
  return static_cast<std::size_t>(std::count_if(world.walls().begin(), world.walls().end(), [&](const Wall& wall) {
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
      if (cross_properly({path.points[i], path.points[i + 1]}, {wall.a, wall.b})) return true;
    return false;
  }));
}

void audit(const Settings& settings, const std::string& name, const Task& task, int side,
           const std::function<Run(const Task&)>& run) {
  if (!std::regex_search(name, settings.filter)) return;
  std::vector<double> ratios, walls;
  int solved = 0, valid = 0;
  for (int i = 0; i < settings.audits; ++i) {
    const Run answer = run(task);
    if (!answer.found) continue;
    ++solved;
    valid += verify(answer.path, task.space, task.from, task.to).valid;
    ratios.push_back(answer.path.length.value() / task.optimum.length.value());
    walls.push_back(static_cast<double>(walls_crossed(answer.path, task.space.world())));
  }
  fmt::print("{:<26}{:>6}{:>9}{:>9}{:>14.0f}{:>9.3f}\n", name, side, fmt::format("{}/{}", solved, settings.audits),
             fmt::format("{}/{}", valid, solved), median(walls), median(ratios));
  std::fflush(stdout);
}

void audits(const Settings& settings) {
  fmt::print("\n{:<26}{:>6}{:>9}{:>9}{:>14}{:>9}\n", "OMPL, sampled motions", "side", "solved", "valid",
             "walls crossed", "length");
  for (const int side : settings.sides) {
    if (side != 25 && side != 61) continue;
    for (const auto& [robot, shape] : {std::pair("point", Footprint::point()), {"disc:0.1", Footprint::disc(0.1)}}) {
      const Task task(maze(side, shape));
      audit(settings, fmt::format("ompl-PRM, {}", robot), task, side,
            [&](const Task& t) { return ompl_run<og::PRM>(t, settings.limit, false); });
      audit(settings, fmt::format("ompl-RRTConnect, {}", robot), task, side,
            [&](const Task& t) { return ompl_run<og::RRTConnect>(t, settings.limit, false); });
    }
  }
}

std::vector<int> numbers_in(const std::string& list) {
  std::vector<int> numbers;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    numbers.push_back(std::stoi(list.substr(from, comma - from)));
    from = comma + 1;
  }
  return numbers;
}

Settings settings_of(int count, char** words) {
  Settings settings;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const auto value_of = [&](std::string_view name) -> std::optional<std::string> {
      return word.starts_with(name) ? std::optional(word.substr(name.size())) : std::nullopt;
    };
    if (const auto filter = value_of("--benchmark_filter=")) settings.filter = std::regex(*filter);
    if (const auto sides = value_of("--sides=")) settings.sides = numbers_in(*sides);
    if (const auto seeds = value_of("--seeds=")) settings.seeds = std::stoi(*seeds);
    if (const auto limit = value_of("--limit=")) settings.limit = std::stod(*limit);
    if (const auto count_of = value_of("--audits=")) settings.audits = std::stoi(*count_of);
  }
  return settings;
}

}  // namespace

int main(int count, char** words) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(1);
  const Settings settings = settings_of(count, words);
  first_paths(settings);
  if (settings.audits > 0) audits(settings);
}
