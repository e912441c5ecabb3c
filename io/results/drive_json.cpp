#include <taut/io/results/drive_json.h>

#include <cmath>
#include <numbers>

#include <taut/io/worlds/roadblock_map.h>

namespace taut {

namespace {

Json json_of(const car::LatticePose& pose) {
  return Json::array({pose.at.x, pose.at.y, car::heading_angle(pose.heading) * 180 / std::numbers::pi});
}

// A leg as driven.
void add_segments(Json& segments, const car::Leg& leg) {
  const car::LegCurve curve = car::curve_of(leg);
  const double gear = leg.backward ? -1 : 1;
  const auto straight = [&](double length) {
    if (length > 0) segments.push_back({{"kind", "straight"}, {"length", gear * length}});
  };
  straight(curve.before);
  if (curve.turn != 0)
    segments.push_back({{"kind", (curve.turn > 0) == (gear > 0) ? "left" : "right"},
                        {"length", gear * curve.radius * std::abs(curve.turn)},
                        {"radius", curve.radius}});
  straight(curve.after);
}

Json json_of(const car::Leg& leg) {
  return {{"from", json_of(leg.from)},
          {"to", json_of(leg.to)},
          {"headings", Json::array({leg.from.heading, leg.to.heading})},
          {"backward", leg.backward}};
}

Json json_of(const car::CarShape& shape) {
  return {{"front", shape.front},
          {"back", shape.back},
          {"half_width", shape.half_width},
          {"radius", shape.radius},
          {"reverse", shape.reverse}};
}

void add_way(Json& json, const car::PlannedDrive& drive, double weight) {
  json["length"] = drive.length;
  json["lower_bound"] = drive.lower_bound;
  json["weight"] = weight;
  json["collisions"] = 0;
  json["verified"] = true;
  json["reversals"] = car::reversals_of(drive.legs);
  json["start"] = json_of(drive.start);
  json["end"] = json_of(drive.legs.empty() ? drive.start : drive.legs.back().to);
  Json segments = Json::array(), legs = Json::array();
  for (const car::Leg& leg : drive.legs) {
    add_segments(segments, leg);
    legs.push_back(json_of(leg));
  }
  json["segments"] = std::move(segments);
  json["legs"] = std::move(legs);
}

}  // namespace

Json roadblock_drive_json(const RoadblockDrive& drive, const roadblocks::Course& course, bool controls) {
  Json json{{"sample", drive.sample.number},
            {"open", bits_of(drive.sample.open, course)},
            {"reached", drive.reached()},
            {"outcome", name(drive.drive.outcome)},
            {"steps", drive.steps()},
            {"collisions", drive.drive.outcome == roadblocks::Outcome::collision ? 1 : 0},
            {"replans", drive.drive.replans},
            {"first_plan_ms", drive.first_plan},
            {"slowest_replan_ms", drive.slowest_replan}};
  if (drive.policy_exact) json["policy_exact"] = *drive.policy_exact;
  if (controls) json["controls"] = drive.drive.controls;
  return json;
}

Json car_drive_json(const car::PlannedDrive& drive, const car::CarShape& shape, double weight) {
  const bool found = drive.status == SearchStatus::found;
  Json json{{"reached", found}, {"car", json_of(shape)}};
  if (found) add_way(json, drive, weight);
  json["lattice"] = {{"step", drive.step},
                     {"headings", drive.headings},
                     {"searched", drive.lattices},
                     {"expanded", drive.expanded},
                     {"tested", drive.tested}};
  return json;
}

}  // namespace taut
