#include <taut/search/planners.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/search/funnel.h>
#include <taut/search/verify.h>

namespace taut {

namespace {

// What `work` gives; its time goes to `seconds`.
template <typename Work>
auto timed(Stopwatch::Of of, Seconds& seconds, Work work) {
  const Stopwatch watch(of);
  auto result = work();
  seconds = watch.seconds();
  return result;
}

constexpr std::size_t kMostPlaces = 20'000;

PlannerRun run_once(const Planner& planner, const RoadmapKind& kind, const FreeSpace& space, Point from, const Goal& to,
                    BuildRequest request) {
  PlannerRun run;
  request.from = from;
  request.to = to;
  // Others may plan beside; what shares its own work among threads counts them all.
  const auto of = request.jobs > 1 ? Stopwatch::Of::process : Stopwatch::Of::thread;
  const PlannedRoadmap planned = timed(of, run.build, [&] { return kind.build(space, request); });
  GraphSearchResult found = timed(of, run.query, [&] { return planned.search(from, to, planner.algorithm); });
  run.roadmap = planned.roadmap;
  run.counts = planned.counts;
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
      {"polyanya", "polyanya", "on the navigation mesh, without a graph; the shortest path"},
      {"visibility-astar", "visibility", "A* on the reduced visibility graph; the shortest path"},
      {"visibility-dijkstra", "visibility", "Dijkstra's algorithm on it", GraphAlgorithm::dijkstra},
      {"full-visibility", "full", "A* on the full visibility graph; the shortest path"},
      {"cells4", "cells", "A* from cell to cell of a grid maze, along the axes"},
      {"cells8", "cells8", "likewise, and across corners"},
      {"prm", "prm", "a probabilistic roadmap that grows until start and goal are joined"},
      {"prm-funnel", "prm", "likewise, its path pulled taut", GraphAlgorithm::astar, true},
      {"prm-lattice", "prm-lattice", "likewise, samples on a lattice"},
      {"voronoi", "voronoi", "along the Voronoi diagram, in the middle between walls"},
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

bool PlannerRuns::all_verified() const {
  return std::all_of(runs.begin(), runs.end(), [](const PlannerRun& r) { return !r.solved || r.verified; });
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

void Comparison::add(PlannerRuns more) {
  planners.push_back(std::move(more));
  const PlannerRuns& last = planners.back();
  if (!optimum && last.optimal && last.solved() > 0) optimum = last.typical().path.length;
}

const PlannerRuns* Comparison::wrong() const {
  const auto first =
      std::find_if(planners.begin(), planners.end(), [](const PlannerRuns& p) { return !p.all_verified(); });
  return first == planners.end() ? nullptr : &*first;
}

std::string too_large(const Planner& planner, const FreeSpace& space) {
  const std::size_t places = space.triangulation().sectors.size();
  if (std::string(planner.kind) != "full" || places <= kMostPlaces) return {};
  return std::to_string(places) + " places are many for a full visibility graph";
}

PlannerRuns run_planner(const Planner& planner, const FreeSpace& space, Point from, const Goal& to, std::uint64_t seed,
                        std::size_t runs, const BuildRequest& request) {
  const RoadmapKind& kind = *roadmap_kind(planner.kind);
  PlannerRuns all{&planner, kind.optimal, {}, {}};
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

}  // namespace taut
