#include <taut/io/results/arc_json.h>

#include <taut/io/results/kept_json.h>
#include <taut/io/results/plane_json.h>

namespace taut {

namespace {

Json pinch_json(const std::optional<ArcPinch>& pinch) {
  if (!pinch) return nullptr;
  const NamedGate& gate = pinch->gate;
  return {{"at", pinch->at}, {"posts", gate.at}, {"width", gate.width}, {"width_text", gate.width_text}};
}

void add_path(Json& json, const ArcAnswer& answer) {
  const ArcPath& path = answer.result.path;
  json["length"] = path.value();
  json["length_interval"] = {path.length.lo, path.length.hi};
  if (answer.within)
    json["within"] = *answer.within;
  else
    json["optimal"] = true;
  json["corners"] = path.bends.size();
  json["verified"] = answer.verified;
  add_arc_path(json, path);
  json["pinch"] = pinch_json(answer.pinch);
}

}  // namespace

Json arc_json(const ArcAnswer& answer) {
  Json json = Json::object();
  if (answer.result.status == DiscStatus::found) add_path(json, answer);
  if (!answer.barrier.walls.empty() || !answer.barrier.gates.empty()) {
    json["barrier"] = barrier_json(answer.barrier);
    if (answer.within) json["within"] = *answer.within;
  }
  json["start"] = answer.start;
  json["goal"] = {{"point", answer.goal}};
  json["robot"] = robot_json(Footprint::disc(answer.radius));
  return json;
}

}  // namespace taut
