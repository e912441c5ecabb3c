#include <taut/io/results/plane_json.h>

namespace taut {

Json goal_json(const Goal& goal) {
  if (goal.point) return {{"point", *goal.point}};
  if (goal.room.empty()) return nullptr;
  Json boxes = Json::array();
  for (const Box& b : goal.room) boxes.push_back({b.min.x, b.min.y, b.max.x, b.max.y});
  return {{"room", boxes}};
}

Json robot_json(const Footprint& robot) {
  static constexpr const char* kKinds[] = {"point", "disc", "polygon"};
  Json json{{"kind", kKinds[static_cast<int>(robot.kind())]}};
  if (robot.radius() > 0) json["radius"] = robot.radius();
  return json;
}

Json prm_json(const PrmConnectivity& prm) {
  return {{"samples", prm.counts.drawn},         {"vertices", prm.counts.kept},
          {"edges", prm.counts.edges},           {"edges_tested", prm.counts.edges_tested},
          {"components", prm.counts.components}, {"start_part", prm.start_part},
          {"goal_part", prm.goal_part}};
}

Json barrier_json(const Barrier& barrier) {
  Json gates = Json::array();
  for (const NamedGate& gate : barrier.gates)
    gates.push_back({{"posts", gate.at}, {"width", gate.width}, {"width_text", gate.width_text}});
  return {{"walls", barrier.walls}, {"gates", gates}};
}

}  // namespace taut
