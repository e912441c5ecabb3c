#include <taut/io/results/result_json.h>

#include <nlohmann/json.hpp>

#include <cmath>

#include <taut/io/results/detail/result_values.h>

namespace taut {

namespace {

using Json = nlohmann::ordered_json;
using detail::json_of;

Json goal_of(const Goal& goal) {
  if (goal.point) return {{"point", json_of(*goal.point)}};
  if (goal.room.empty()) return nullptr;
  Json boxes = Json::array();
  for (const Box& b : goal.room) boxes.push_back({b.min.x, b.min.y, b.max.x, b.max.y});
  return {{"room", boxes}};
}

Json robot_of(const Footprint& robot) {
  static constexpr const char* kKinds[] = {"point", "disc", "polygon"};
  Json json{{"kind", kKinds[static_cast<int>(robot.kind())]}};
  if (robot.radius() > 0) json["radius"] = robot.radius();
  return json;
}

Json seconds_of(const StageSeconds& s) {
  return {{"read", s.read},     {"space", s.space},   {"roadmap", s.roadmap},
          {"search", s.search}, {"verify", s.verify}, {"total", s.total}};
}

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
  json["optimal"] = result.optimal;
  json["points"] = detail::json_of(result.path.points);
  json["corners"] = result.path.points.size() > 2 ? result.path.points.size() - 2 : 0;
  json["clearance"] = result.clearance && std::isfinite(*result.clearance) ? Json(*result.clearance) : Json(nullptr);
  json["verified"] = result.verified;
}

void add_outcome(Json& json, const PlanResult& result) {
  switch (result.status) {
    case SearchStatus::found: return add_path(json, result);
    case SearchStatus::none:
      json["separation"] = detail::json_of(result.separation);
      if (!result.reason.empty()) json["reason"] = result.reason;
      return;
    case SearchStatus::stopped: json["reason"] = result.reason; json["stage"] = result.stage;
  }
}

}  // namespace

const char* name(SearchStatus status) {
  return status == SearchStatus::found ? "found" : status == SearchStatus::none ? "none" : "stopped";
}

std::string result_json(const PlanResult& result) {
  Json json{
      {"program", "taut"}, {"version", result.version}, {"source", result.source}, {"status", name(result.status)}};
  add_outcome(json, result);
  json["start"] = result.start ? json_of(*result.start) : Json(nullptr);
  json["goal"] = goal_of(result.goal);
  json["robot"] = robot_of(result.robot);
  json["roadmap"] = result.roadmap;
  json["wall_thickness"] = result.wall_thickness;
  json["displacement"] = result.displacement;
  json["expanded"] = result.expanded;
  if (result.method) {
    json["algorithm"] = name(result.method->algorithm);
    if (uses_heuristic(result.method->algorithm)) json["heuristic"] = name(result.method->heuristic);
  }
  if (const auto& over = result.overestimate)
    json["overestimate"] = {{"at", json_of(over->at)}, {"estimate", over->estimate}, {"cost", over->cost}};
  if (result.unpulled) json["length_in_roadmap"] = result.unpulled->value();
  if (result.prm) json["prm"] = json_of(*result.prm);
  if (result.bound) {
    json["bound"] = *result.bound;
    json["improvements"] = improvements_of(result.improvements);
  }
  json["seconds"] = seconds_of(result.seconds);
  return detail::json_text(json);
}

}  // namespace taut
