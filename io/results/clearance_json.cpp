#include <taut/io/results/clearance_json.h>

#include <cmath>

#include <taut/geometry/rounding.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/plane_json.h>

namespace taut {

namespace {

using Kind = ClearanceQuery::Kind;

Json curves_of(const ClearancePath& way) {
  Json curves = Json::array();
  for (const Bezier& c : way.curves) curves.push_back({c.from, c.control, c.to});
  return curves;
}

Json pinch_of(const Pinch& pinch, const FreeSpace& space) {
  static constexpr const char* kPlaces[] = {"gate", "start", "goal"};
  Json walls = Json::array();
  for (std::size_t i = 0; i < 2; ++i)
    if (pinch.constraints[i] != kNone) walls.push_back(wall_of(space, pinch.constraints[i], &pinch.posts[i]));
  return {{"at", kPlaces[static_cast<int>(pinch.where)]},
          {"clearance", pinch.clearance},
          {"posts", Segment{pinch.posts[0], pinch.posts[1]}},
          {"walls", walls}};
}

void add_way(Json& json, const ClearanceTrade& trade, const FreeSpace& space) {
  json["radius"] = trade.clearance;
  json["length"] = trade.path.length;
  json["shortest_in"] = "diagram";
  json["pinch"] = pinch_of(trade.path.pinch, space);
  json["curves"] = curves_of(trade.path);
}

void add_found(Json& json, const ClearanceAnswer& answer, const FreeSpace& space) {
  if (answer.query.kind == Kind::tradeoff) {
    json["tradeoff"] = Json::array();
    for (const ClearanceTrade& t : answer.found) json["tradeoff"].push_back(clearance_way_json(t, space));
  } else {
    add_way(json, answer.found.front(), space);
  }
  json["verified"] = answer.verified;
  if (answer.query.kind != Kind::widest) return;
  json["width"] = answer.width;
  json["radius_below"] = answer.limit ? Json(answer.limit->radius) : Json();
  if (!answer.barrier.gates.empty()) json["barrier"] = barrier_json(answer.barrier);
}

}  // namespace

Json clearance_way_json(const ClearanceTrade& way, const FreeSpace& walled) {
  Json json;
  add_way(json, way, walled);
  return json;
}

Json clearance_json(const ClearanceAnswer& answer, const FreeSpace& walled) {
  static constexpr const char* kQueries[] = {"clearance", "widest", "tradeoff"};
  Json json{{"query", kQueries[static_cast<int>(answer.query.kind)]}};
  if (answer.query.kind == Kind::at_least) json["asked"] = answer.query.clearance;
  if (!answer.found.empty()) add_found(json, answer, walled);
  if (answer.status == SearchStatus::none) json["barrier"] = barrier_json(answer.barrier);
  json["start"] = answer.start;
  json["goal"] = {{"point", answer.goal}};
  json["robot"] = {{"kind", "point"}};
  json["roadmap"] = "voronoi";
  json["vertices"] = answer.places.at(0);
  json["edges"] = answer.places.at(1);
  json["max_error"] = answer.max_error;
  if (answer.within > 0) json["within"] = answer.within;
  return json;
}

Json passage_json(const Passage& passage, const Gates& gates) {
  static constexpr const char* kLimits[] = {"gate", "start", "goal", "none"};
  Json json{{"start", passage.start}, {"goal", Json{{"point", passage.goal}}}};
  if (passage.radius) json["radius"] = *passage.radius;
  json["largest"] = nullptr;
  if (passage.widest)
    json["largest"] = {{"radius", passage.widest->radius},  // infinite: null
                       {"limit", kLimits[static_cast<int>(passage.widest->limit)]},
                       {"reason", limit_text(gates, *passage.widest, passage.start, passage.goal)}};
  json["barrier"] = barrier_json(passage.barrier);
  json["gates"] = gates.gates().size();
  if (const double within = rounding_bound(gates.space()); within > 0) json["within"] = within;
  return json;
}

}  // namespace taut
