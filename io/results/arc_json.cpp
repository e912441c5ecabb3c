#include <taut/io/results/arc_json.h>

#include <nlohmann/json.hpp>

#include <taut/io/results/detail/result_values.h>

namespace taut {

namespace {

using Json = nlohmann::ordered_json;
using detail::json_of;

void add_path(Json& json, const ArcPath& path, bool verified) {
  json["length"] = path.value();
  json["length_interval"] = {path.length.lo, path.length.hi};
  json["verified"] = verified;
  Json bends = Json::array(), arcs = Json::array(), points = Json::array({json_of(path.start)});
  for (const ArcBend& bend : path.bends) bends.push_back({bend.corner.x, bend.corner.y, bend.turn});
  for (const ArcPiece& p : pieces(path)) {
    if (p.turn != 0) arcs.push_back({p.centre.x, p.centre.y, p.from.x, p.from.y, p.to.x, p.to.y, p.turn, p.sweep});
    points.push_back(json_of(p.to));
  }
  json["bends"] = bends;
  json["arcs"] = arcs;
  json["points"] = points;
}

}  // namespace

std::string arc_json(const ArcSearchResult& result, const FreeSpace& space, Point start, Point goal, double radius,
                     bool verified, const std::string& source, const std::string& version) {
  static constexpr const char* kStatus[] = {"found", "none", "start_blocked", "goal_blocked"};
  const bool is_unproven = result.status == ArcStatus::none && !verified;
  Json json{{"program", "taut"},
            {"version", version},
            {"source", source},
            {"status", is_unproven ? "unproven" : kStatus[static_cast<int>(result.status)]}};
  if (result.status == ArcStatus::found) add_path(json, result.path, verified);
  if (result.status == ArcStatus::start_blocked || result.status == ArcStatus::goal_blocked) {
    json["wall"] = nullptr;
    if (result.wall != kNone) {
      const Constraint& wall = space.constraints()[result.wall];
      json["wall"] = json_of(Segment{wall.a, wall.b});
    }
  }
  json["start"] = json_of(start);
  json["goal"] = json_of(goal);
  json["robot"] = {{"kind", "disc"}, {"radius", radius}};
  return detail::json_text(json);
}

}  // namespace taut
