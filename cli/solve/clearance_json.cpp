#include <nlohmann/json.hpp>

#include <cmath>

#include <taut/cli/solve/clearance_report.h>
#include <taut/io/results/detail/result_values.h>

namespace taut::cli {

namespace {

using Json = nlohmann::ordered_json;
using Kind = ClearanceQuery::Kind;
using detail::json_of;

Json curves_of(const ClearancePath& way) {
  Json curves = Json::array();
  for (const VoronoiCurve& c : way.curves) curves.push_back({json_of(c.from), json_of(c.control), json_of(c.to)});
  return curves;
}

Json pinch_of(const Pinch& pinch, const FreeSpace& space) {
  static constexpr const char* kPlaces[] = {"gate", "start", "goal"};
  Json walls = Json::array();
  for (std::size_t i = 0; i < 2; ++i)
    if (pinch.constraints[i] != kNone) walls.push_back(json_of(wall_of(space, pinch.constraints[i], &pinch.posts[i])));
  return {{"at", kPlaces[static_cast<int>(pinch.where)]},
          {"clearance", pinch.clearance},
          {"posts", {json_of(pinch.posts[0]), json_of(pinch.posts[1])}},
          {"walls", walls}};
}

Json way_of(const ClearanceTrade& trade, const FreeSpace& space) {
  return {{"radius", trade.clearance},
          {"length", trade.path.length},
          {"shortest_in", "diagram"},
          {"pinch", pinch_of(trade.path.pinch, space)},
          {"curves", curves_of(trade.path)}};
}

Json optional_point(const std::optional<Point>& p) { return p ? json_of(*p) : Json(nullptr); }

void add_found(Json& json, const ClearanceAnswer& answer, const FreeSpace& space) {
  if (answer.query.kind == Kind::tradeoff) {
    json["tradeoff"] = Json::array();
    for (const ClearanceTrade& t : answer.found) json["tradeoff"].push_back(way_of(t, space));
  } else {
    json.update(way_of(answer.found.front(), space));
  }
  json["verified"] = answer.verified;
  if (answer.query.kind != Kind::widest) return;
  json["width"] = answer.width ? Json(*answer.width) : Json(nullptr);
  json["radius_below"] = answer.limit ? Json(answer.limit->radius) : Json(nullptr);
  if (!answer.barrier.gates.empty()) json["barrier"] = barrier_json(answer.barrier);
}

}  // namespace

Json barrier_json(const Barrier& barrier) {
  Json gates = Json::array();
  for (const NamedGate& gate : barrier.gates)
    gates.push_back({{"posts", json_of(gate.at)}, {"width", gate.width}, {"width_text", gate.width_text}});
  return {{"walls", json_of(barrier.walls)}, {"gates", gates}};
}

std::string clearance_json(const ClearanceAnswer& answer, const FreeSpace& space) {
  static constexpr const char* kQueries[] = {"", "clearance", "widest", "tradeoff"};
  Json json{{"program", "taut"},
            {"version", TAUT_VERSION},
            {"source", answer.source},
            {"query", kQueries[static_cast<int>(answer.query.kind)]}};
  if (answer.query.kind == Kind::at_least) json["asked"] = answer.query.clearance;
  json["status"] = name(answer.status);
  if (answer.status == SearchStatus::found) add_found(json, answer, space);
  if (answer.status == SearchStatus::none) json["barrier"] = barrier_json(answer.barrier);
  if (answer.status != SearchStatus::found) json["reason"] = answer.reason;
  if (answer.status == SearchStatus::stopped) json["stage"] = answer.stage;
  json["start"] = optional_point(answer.start);
  json["goal"] = answer.goal ? Json{{"point", json_of(*answer.goal)}} : Json(nullptr);
  json["robot"] = {{"kind", "point"}};
  json["roadmap"] = "voronoi";
  json["vertices"] = answer.places.at(0);
  json["edges"] = answer.places.at(1);
  json["max_error"] = std::isfinite(answer.max_error) ? Json(answer.max_error) : Json(nullptr);
  const StageSeconds& s = answer.seconds;
  json["seconds"] = {{"read", s.read},     {"space", s.space},   {"roadmap", s.roadmap},
                     {"search", s.search}, {"verify", s.verify}, {"total", s.total}};
  return detail::json_text(json);
}

}  // namespace taut::cli
