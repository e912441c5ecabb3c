#include <nlohmann/json.hpp>

#include <taut/cli/solve/compare_report.h>

namespace taut::cli {

namespace {

using Json = nlohmann::ordered_json;

Json clearance_of(const PlannerRun& run) { return run.clearance ? Json(*run.clearance) : Json(nullptr); }

Json length_of(const PlannerRun& run) { return run.solved ? Json(run.path.length.value()) : Json(nullptr); }

Json ratio_of(const PlannerRun& run, const std::optional<Length>& optimum) {
  if (!run.solved || !optimum) return nullptr;
  return run.path.length == *optimum ? 1.0 : run.path.length.value() / optimum->value();
}

Json points_of(const PlannerRun& run) {
  Json points = Json::array();
  for (const Point p : run.path.points) points.push_back({p.x, p.y});
  return points;
}

Json all_runs_of(const PlannerRuns& p, const Comparison& comparison) {
  Json all = Json::array();
  for (std::size_t i = 0; i < p.runs.size(); ++i) {
    const PlannerRun& run = p.runs[i];
    all.push_back({{"seed", comparison.seed + i},
                   {"solved", run.solved},
                   {"length", length_of(run)},
                   {"ratio", ratio_of(run, comparison.optimum)},
                   {"clearance", clearance_of(run)},
                   {"vertices", run.vertices},
                   {"edges", run.edges},
                   {"build_seconds", run.build_seconds},
                   {"query_seconds", run.query_seconds},
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
  json["optimal"] = p.optimal;
  json["solved"] = static_cast<double>(p.solved()) / static_cast<double>(p.runs.size());
  json["length"] = length_of(typical);
  json["ratio"] = ratio_of(typical, comparison.optimum);
  json["clearance"] = clearance_of(typical);
  json["points"] = points_of(typical);
  json["vertices"] = typical.vertices;
  json["edges"] = typical.edges;
  json["build_seconds"] = p.median([](const PlannerRun& r) { return r.build_seconds; });
  json["query_seconds"] = p.median([](const PlannerRun& r) { return r.query_seconds; });
  json["expanded"] = typical.expanded;
  json["verified"] = typical.verified;
  if (p.runs.size() > 1) json["all_runs"] = all_runs_of(p, comparison);
  return json;
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
  Json json{{"program", "taut"}, {"source", comparison.source}, {"seed", comparison.seed}, {"runs", comparison.runs}};
  json["optimum"] = comparison.optimum ? Json(comparison.optimum->value()) : Json(nullptr);
  json["proven_none"] = comparison.is_shut;
  json["planners"] = Json::array();
  for (const PlannerRuns& p : comparison.planners) json["planners"].push_back(planner_json(p, comparison));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace taut::cli
