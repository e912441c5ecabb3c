#include <taut/io/results/comparison_json.h>

#include <taut/io/results/plane_json.h>

namespace taut {

namespace {

Json length_of(const PlannerRun& run) { return run.solved ? Json(run.path.length.value()) : Json(); }

Json ratio_of(const PlannerRun& run, const std::optional<Length>& optimum) {
  if (!run.solved || !optimum) return nullptr;
  return run.path.length == *optimum ? 1.0 : run.path.length.value() / optimum->value();
}

// What Roadmap keeps: a point and an offset each vertex, both ends of each edge.
std::size_t graph_bytes(const PlannerRun& run) { return 24 * run.vertices + 8 * run.edges; }

Json all_runs_of(const PlannerRuns& p, const Comparison& comparison) {
  Json all = Json::array();
  for (std::size_t i = 0; i < p.runs.size(); ++i) {
    const PlannerRun& run = p.runs[i];
    all.push_back({{"seed", comparison.seed + i},
                   {"solved", run.solved},
                   {"length", length_of(run)},
                   {"ratio", ratio_of(run, comparison.optimum)},
                   {"clearance", run.clearance},
                   {"vertices", run.vertices},
                   {"edges", run.edges},
                   {"graph_bytes", graph_bytes(run)},
                   {"build_seconds", run.build.cpu},
                   {"query_seconds", run.query.cpu},
                   {"expanded", run.expanded},
                   {"verified", run.verified}});
  }
  return all;
}

Json planner_json(const PlannerRuns& p, const Comparison& comparison) {
  Json json{{"name", p.planner->name}, {"roadmap", p.planner->kind}};
  if (p.runs.empty()) {
    json["unfit"] = p.unfit;
    return json;
  }
  const PlannerRun& typical = p.typical();
  if (p.optimal && comparison.within > 0)
    json["within"] = comparison.within;
  else
    json["optimal"] = p.optimal;
  json["solved"] = static_cast<double>(p.solved()) / static_cast<double>(p.runs.size());
  json["length"] = length_of(typical);
  json["ratio"] = ratio_of(typical, comparison.optimum);
  json["clearance"] = typical.clearance;
  json["points"] = typical.path.points;
  json["vertices"] = typical.vertices;
  json["edges"] = typical.edges;
  json["graph_bytes"] = graph_bytes(typical);
  json["build_seconds"] = p.median([](const PlannerRun& r) { return r.build.cpu; });
  json["query_seconds"] = p.median([](const PlannerRun& r) { return r.query.cpu; });
  json["expanded"] = typical.expanded;
  json["verified"] = typical.verified;
  if (p.runs.size() > 1) json["all_runs"] = all_runs_of(p, comparison);
  return json;
}

}  // namespace

Json comparison_json(const Comparison& comparison) {
  Json json{{"seed", comparison.seed}, {"runs", comparison.runs}};
  json["start"] = comparison.start;
  json["goal"] = goal_json(comparison.goal);
  json["optimum"] = comparison.optimum ? Json(comparison.optimum->value()) : Json();
  json["proven_none"] = comparison.is_shut;
  if (comparison.within > 0) json["within"] = comparison.within;
  json["planners"] = Json::array();
  for (const PlannerRuns& p : comparison.planners) json["planners"].push_back(planner_json(p, comparison));
  return json;
}

}  // namespace taut
