#include <taut/io/results/end_moves.h>

#include <fmt/format.h>

#include <taut/io/results/words.h>

namespace taut {

Json end_moves_json(const std::vector<EndMove>& moves) {
  Json json = Json::array();
  for (const EndMove& move : moves)
    json.push_back({{"end", move.role},
                    {"given", move.given},
                    {"moved_to", move.place.point},
                    {"distance", move.place.distance},
                    {"rounding", move.place.rounding}});
  return json;
}

std::string end_move_text(const EndMove& move) {
  return fmt::format("{} moved {:.6g} from {}", move.role, move.place.distance, point_text(move.given));
}

std::vector<Segment> end_move_lines(const std::vector<EndMove>& moves) {
  std::vector<Segment> lines;
  lines.reserve(moves.size());
  for (const EndMove& move : moves) lines.push_back({move.given, move.place.point});
  return lines;
}

}  // namespace taut
