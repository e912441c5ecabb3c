// What ompl_bench compares: our planners and OMPL's, asked in the same way.
#pragma once

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

#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include <taut/search/funnel.h>
#include <taut/search/prm_request.h>
#include <taut/search/shortest_path.h>

namespace taut::bench {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// Of the whole process: OMPL's PRM has a second thread that looks for solutions.
inline double cpu_seconds() {
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
  bool optimal = false;  ///< exactly
  double ratio = 0;      ///< length over that of the shortest path
};

struct Row {
  std::string name;
  std::function<Run(const Task&, std::uint64_t seed, double limit)> run;
  int largest = 1'000'000;  // side
};

// ---- taut -----------------------------------------------------------------------------------------------------------

inline Run our_prm(const Task& task, std::uint64_t seed, double limit, PrmConnection connection, bool pull,
                   PrmSampler sampler = PrmSampler::sobol) {
  PrmPlan plan = plan_of({.connection = connection}, sampler, seed, true);  // as the program has it
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

inline Run our_exact(const Task& task) {
  const double begin = cpu_seconds();
  const VisibilityGraph graph(task.space);
  GraphSearchResult result = shortest_path(graph, task.from, task.to);
  return {result.status == SearchStatus::found, cpu_seconds() - begin, std::move(result.path),
          static_cast<double>(graph.roadmap().vertex_count()), static_cast<double>(graph.roadmap().edge_count())};
}

// ---- OMPL -----------------------------------------------------------------------------------------------------------

inline Point point_of(const ob::State* state) {
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
inline ob::SpaceInformationPtr information_of(const FreeSpace& space, bool exact) {
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
inline ob::ProblemDefinitionPtr problem_of(const ob::SpaceInformationPtr& information, const Task& task) {
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

}  // namespace taut::bench
