#include <taut/io/results/kept_json.h>

#include <taut/io/results/plane_json.h>

namespace taut {

namespace {

void add_path(Json& json, const KeptAnswer& answer) {
  const KeptPath& path = answer.path;
  json["length"] = path.length.middle();
  json["length_interval"] = {path.length.lo, path.length.hi};
  if (answer.within)
    json["within"] = *answer.within;
  else
    json["optimal"] = true;
  std::size_t corners = 0;
  Json parts = Json::array(), points = Json::array({answer.start});
  for (std::size_t i = 0; i < path.parts.size(); ++i) {
    const ArcPath& part = path.parts[i];
    Json one = {{"radius", part.radius},
                {"length", part.value()},
                {"leaves", i < path.first   ? Json("start")
                           : i >= path.last ? Json("goal")
                                            : Json(nullptr)}};
    add_arc_path(one, part);
    corners += part.bends.size();
    for (const ArcPiece& piece : pieces(part)) points.push_back(piece.to);
    parts.push_back(std::move(one));
  }
  json["corners"] = corners;
  json["verified"] = answer.verified;
  json["parts"] = parts;
  json["points"] = points;
  json["place_rounding"] = path.rounding;
}

}  // namespace

void add_arc_path(Json& json, const ArcPath& path) {
  Json bends = Json::array(), arcs = Json::array(), points = Json::array({path.start});
  for (const ArcBend& bend : path.bends) bends.push_back({bend.corner.x, bend.corner.y, bend.turn});
  for (const ArcPiece& p : pieces(path)) {
    if (p.turn != 0) arcs.push_back({p.centre.x, p.centre.y, p.from.x, p.from.y, p.to.x, p.to.y, p.turn, p.sweep});
    points.push_back(p.to);
  }
  json["bends"] = bends;
  json["arcs"] = arcs;
  json["points"] = points;
}

Json kept_json(const KeptAnswer& answer) {
  Json json = {{"query", "keep"}, {"asked", answer.path.clearance}};
  if (answer.path.status == KeptPath::Status::found) add_path(json, answer);
  if (!answer.barrier.walls.empty() || !answer.barrier.gates.empty()) json["barrier"] = barrier_json(answer.barrier);
  json["start"] = answer.start;
  json["goal"] = {{"point", answer.goal}};
  json["robot"] = robot_json(Footprint::point());
  return json;
}

}  // namespace taut
