#include <taut/io/results/bug_json.h>

#include <cmath>

namespace taut::bug {

namespace {

Json json_of(const std::vector<Contact>& contacts) {
  Json array = Json::array();
  for (const Contact& c : contacts)
    array.push_back({{"point", c.at}, {"distance", c.distance}, {"obstacle", c.obstacle}});
  return array;
}

Json json_of(const Obstacle& obstacle, Algorithm algorithm) {
  Json json{{"perimeter", obstacle.perimeter.hi}, {"hits", obstacle.hits}};
  if (algorithm == Algorithm::bug2) json["entries"] = obstacle.entries;
  if (algorithm == Algorithm::tangent) json["legs"] = obstacle.legs;
  return json;
}

}  // namespace

std::optional<double> ratio_of(const Journey& journey, const std::optional<Length>& shortest) {
  if (!journey.reached || !shortest || shortest->value() == 0) return std::nullopt;
  return journey.path.length.value() / shortest->value();
}

Json bug_json(const Journey& journey, const Options& options, Point start, Point goal,
              const std::optional<Length>& shortest) {
  const bool is_tangent = options.algorithm == Algorithm::tangent;
  Json json{{"algorithm", name(options.algorithm)}, {"turn", options.turn == Turn::left ? "left" : "right"}};
  if (is_tangent) json["range"] = std::isinf(options.range) ? Json("inf") : Json(options.range);
  json["start"] = start;
  json["goal"] = Json::object();
  json["goal"]["point"] = goal;
  json["length"] = journey.path.length.value();
  if (shortest) json["shortest"] = shortest->value();
  if (const auto ratio = ratio_of(journey, shortest)) json["ratio"] = *ratio;
  json["bound"] = journey.bound.hi;
  json["rounding"] = journey.rounding;
  json["hits"] = json_of(journey.hits);
  if (is_tangent) json["minima"] = json_of(journey.minima);
  json["leaves"] = json_of(journey.leaves);
  json["obstacles"] = Json::array();
  for (const Obstacle& o : journey.obstacles) json["obstacles"].push_back(json_of(o, options.algorithm));
  json["path"] = journey.path.points;
  return json;
}

}  // namespace taut::bug
