#include <taut/cli/solve/planners.h>

#include <algorithm>
#include <cmath>

#include <taut/cli/timing.h>
#include <taut/geometry/errors.h>
#include <taut/search/funnel.h>
#include <taut/search/verify.h>

namespace taut::cli {

namespace {

PlannerRun run_once(const Planner& planner, const RoadmapKind& kind, const FreeSpace& space, Point from, const Goal& to,
                    BuildRequest request) {
  PlannerRun run;
  request.from = from;
  request.to = to;
  const PlannedRoadmap planned = timed(planner.name, run.build_seconds, [&] { return kind.build(space, request); });
  GraphSearchResult found =
      timed(planner.name, run.query_seconds, [&] { return planned.search(from, to, planner.algorithm); });
  run.roadmap = planned.roadmap;
  run.vertices = planned.roadmap->vertex_count();
  run.edges = planned.roadmap->edge_count();
  run.expanded = found.expanded;
  run.solved = found.status == SearchStatus::found;
  if (!run.solved) return run;
  run.path = std::move(found.path);
  if (planner.shortens) run.path = shortened(space, run.path).value();
  const Verdict verdict = verify(run.path, space, from, to);
  run.verified = verdict.valid;
  if (verdict.valid && std::isfinite(verdict.clearance)) run.clearance = verdict.clearance;
  return run;
}

}  // namespace

std::span<const Planner> planners() {
  static constexpr Planner kPlanners[] = {
      {"polyanya", "polyanya", GraphAlgorithm::astar},
      {"visibility-astar", "visibility", GraphAlgorithm::astar},
      {"visibility-dijkstra", "visibility", GraphAlgorithm::dijkstra},
      {"full-visibility", "full", GraphAlgorithm::astar},
      {"cells4", "cells", GraphAlgorithm::astar},
      {"cells8", "cells8", GraphAlgorithm::astar},
      {"prm", "prm", GraphAlgorithm::astar},
      {"prm-funnel", "prm", GraphAlgorithm::astar, true},
      {"prm-lattice", "prm-lattice", GraphAlgorithm::astar},
      {"voronoi", "voronoi", GraphAlgorithm::astar},
  };
  return kPlanners;
}

const Planner* planner(const std::string& name) {
  for (const Planner& p : planners())
    if (name == p.name) return &p;
  return nullptr;
}

std::string planner_names() {
  std::string names;
  for (const Planner& p : planners()) names.append(names.empty() ? "" : ", ").append(p.name);
  return names;
}

std::size_t PlannerRuns::solved() const {
  return static_cast<std::size_t>(
      std::count_if(runs.begin(), runs.end(), [](const PlannerRun& r) { return r.solved; }));
}

const PlannerRun& PlannerRuns::typical() const {
  std::vector<const PlannerRun*> order;
  for (const PlannerRun& run : runs)
    if (run.solved) order.push_back(&run);
  if (order.empty()) return runs.front();
  std::stable_sort(order.begin(), order.end(), [](const PlannerRun* a, const PlannerRun* b) {
    return a->path.length.value() < b->path.length.value();
  });
  return *order[order.size() / 2];
}

double PlannerRuns::median(double (*number)(const PlannerRun&)) const {
  std::vector<double> all;
  for (const PlannerRun& run : runs) all.push_back(number(run));
  std::sort(all.begin(), all.end());
  return all[all.size() / 2];
}

PlannerRuns run_planner(const Planner& planner, const FreeSpace& space, Point from, const Goal& to, std::uint64_t seed,
                        std::size_t runs, const BuildRequest& request) {
  const RoadmapKind& kind = *roadmap_kind(planner.kind);
  PlannerRuns all{&planner, kind.optimal, {}};
  try {
    for (std::size_t i = 0; i < (kind.random ? runs : 1); ++i) {
      BuildRequest wishes = request;
      wishes.seed = seed + i;
      if (!kind.is_prm) wishes.prm = {};
      all.runs.push_back(run_once(planner, kind, space, from, to, std::move(wishes)));
    }
  } catch (const InputError& error) {
    all.runs.clear();
    all.unfit = error.what();
  }
  return all;
}

}  // namespace taut::cli
