#include <taut/io/results/grid_json.h>

namespace taut {

bool is_informed(GridAlgorithm algorithm) {
  return algorithm != GridAlgorithm::bfs && algorithm != GridAlgorithm::dfs && algorithm != GridAlgorithm::dijkstra;
}

Json grid_place_json(GridPlace place) { return {place.row, place.column}; }

Json grid_result_json(const GridResult& result, const GridQuery& query, GridMoves moves) {
  Json json{{"algorithm", name(query.algorithm)}};
  if (is_informed(query.algorithm)) json["heuristic"] = name(query.heuristic);
  json["moves"] = name(moves);
  json["ties"] = query.ties == Ties::fifo ? "fifo" : "lifo";
  json["steps"] = result.steps;
  json["cost"] = nullptr;
  if (result.status == SearchStatus::found) {
    json["cost"] = result.cost.value();
    json["straight"] = result.cost.straight();
    json["diagonal"] = result.cost.diagonal();
    json["optimal"] = result.optimal;
  }
  json["cells"] = result.path.size();
  Json& path = json["path"] = Json::array();
  for (const GridPlace& place : result.path) path.push_back(grid_place_json(place));
  return json;
}

Json heuristic_json(const GridHeuristic& heuristic, const HeuristicVerdict& verdict) {
  Json json{{"heuristic", name(heuristic)}, {"admissible", verdict.admissible()}, {"consistent", verdict.consistent()}};
  if (const auto& o = verdict.overestimate)
    json["overestimate"] = {{"cell", grid_place_json(o->cell)}, {"h", o->estimate}, {"cost", o->cost.value()}};
  if (const auto& m = verdict.violation)
    json["violation"] = {{"from", grid_place_json(m->from)},
                         {"to", grid_place_json(m->to)},
                         {"h_from", m->estimate_from},
                         {"h_to", m->estimate_to},
                         {"cost", m->cost.value()}};
  return json;
}

}  // namespace taut
