#include <taut/io/results/result_json.h>

#include <cmath>

#include <taut/io/results/plane_json.h>
#include <taut/search/corner_count.h>

namespace taut {

namespace {

Json improvements_of(const std::vector<AnytimeImprovement>& improvements) {
  Json json = Json::array();
  for (const AnytimeImprovement& i : improvements)
    json.push_back({{"epsilon", i.epsilon},
                    {"bound", i.bound},
                    {"length", i.length.value()},
                    {"expanded", i.expanded},
                    {"seconds", i.seconds}});
  return json;
}

void add_path(Json& json, const PlanResult& result) {
  const Length& length = result.path.length;
  json["length"] = length.value();
  json["length_text"] = length.decimals(15);
  json["length_interval"] = {length.interval().lo, length.interval().hi};
  if (result.optimal && result.within)
    json["within"] = *result.within;
  else
    json["optimal"] = result.optimal;
  json["points"] = result.path.points;
  json["corners"] = corner_count(result.path.points, result.uncertainty);
  json["clearance"] = result.clearance && std::isfinite(*result.clearance) ? Json(*result.clearance) : Json();
  json["verified"] = result.verified;
}

void add_none(Json& json, const PlanResult& result) {
  json["separation"] = result.separation;
  if (result.within) json["within"] = *result.within;
}

void add_outcome(Json& json, const PlanResult& result) {
  switch (result.status) {
    case SearchStatus::found: return add_path(json, result);
    case SearchStatus::none: return add_none(json, result);
    case SearchStatus::stopped:
      if (!result.path.points.empty()) add_path(json, result);
  }
}

}  // namespace

Json result_json(const PlanResult& result) {
  Json json = Json::object();
  add_outcome(json, result);
  json["start"] = result.start;
  json["goal"] = goal_json(result.goal);
  json["robot"] = robot_json(result.robot);
  json["roadmap"] = result.roadmap;
  json["wall_thickness"] = result.wall_thickness;
  json["displacement"] = result.displacement;
  json["expanded"] = result.expanded;
  if (result.method) {
    json["algorithm"] = name(result.method->algorithm);
    if (uses_heuristic(result.method->algorithm)) json["heuristic"] = name(result.method->heuristic);
  }
  if (const auto& over = result.overestimate)
    json["overestimate"] = {{"at", over->at}, {"estimate", over->estimate}, {"cost", over->cost}};
  if (result.unpulled) json["length_in_roadmap"] = result.unpulled->value();
  if (result.prm) json["prm"] = prm_json(*result.prm);
  if (result.bound) {
    json["bound"] = *result.bound;
    json["improvements"] = improvements_of(result.improvements);
  }
  return json;
}

}  // namespace taut
