#include <taut/io/results/tradeoff_json.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <taut/io/results/barrier_words.h>
#include <taut/io/results/kept_json.h>
#include <taut/io/results/plane_json.h>
#include <taut/io/results/words.h>

namespace taut {

namespace {

using End = TradeoffStretch::End;

Json formula_json(const LengthFormula& formula) {
  Json legs = Json::array();
  for (const LengthFormula::Turning& leg : formula.legs) legs.push_back({leg.d, leg.k});
  return {{"constant", formula.constant}, {"angle", formula.angle}, {"legs", legs}};
}

Json gate_json(const NamedGate& gate) {
  return {{"posts", gate.at}, {"width", gate.width}, {"width_text", gate.width_text}};
}

void add_way(Json& json, const TradeoffStretch& stretch) {
  json["start"] = stretch.start;
  json["goal"] = {{"point", stretch.goal}};
  json["robot"] = {{"kind", "disc"}, {"radius", stretch.to}};  // smaller than a world may ask for, perhaps
  add_arc_path(json, stretch.path(stretch.to));
}

}  // namespace

Json stretch_json(const TradeoffStretch& stretch, double above, const Gates& gates) {
  static constexpr const char* kEnds[] = {"bend", "shorter", "closed", "left", "last"};
  Json json{{"above", above},
            {"radius", stretch.to},
            {"length", stretch.at_to.middle()},
            {"length_above", stretch.at_from.middle()},
            {"then", kEnds[static_cast<int>(stretch.end)]}};
  if (stretch.gate != kNone) json["gate"] = gate_json(named_gate(gates, stretch.gate));
  json["formula"] = formula_json(stretch.formula());
  if (stretch.aside == 0) {
    add_way(json, stretch);
    return json;
  }
  json["aside"] = stretch.aside;
  Json way{{"length", stretch.path(stretch.to).value()}};
  add_way(way, stretch);
  json["way"] = std::move(way);
  return json;
}

Json tradeoff_json(const TradeoffAnswer& answer, const Gates& gates) {
  Json json{{"query", "tradeoff"}, {"tradeoff", Json::array()}};
  double above = 0;
  for (const TradeoffStretch& stretch : answer.found.stretches) {
    json["tradeoff"].push_back(stretch_json(stretch, above, gates));
    above = stretch.to;
  }
  json["verified"] = answer.verified;
  if (answer.within) json["within"] = *answer.within;
  if (!answer.limit.empty()) json["limit"] = answer.limit;
  if (!answer.barrier.walls.empty() || !answer.barrier.gates.empty()) json["barrier"] = barrier_json(answer.barrier);
  json["start"] = answer.start;
  json["goal"] = {{"point", answer.goal}};
  json["robot"] = robot_json(Footprint::point());
  return json;
}

std::string stretch_end_text(const TradeoffStretch& stretch, const Gates& gates) {
  switch (stretch.end) {
    case End::bend: return "a further corner";
    case End::shorter: return "another way is shorter";
    case End::closed: return stretch.gate == kNone ? "closed" : "closed: " + gates.name(stretch.gate);
    case End::left: return "an end is too near to a wall";
    case End::last: return "no way";
  }
  return {};
}

std::string tradeoff_table(const std::vector<TradeoffStretch>& stretches, const Gates& gates) {
  using Row = std::array<std::string, 4>;
  std::vector<Row> rows{{"radius up to", "length from", "to", "then"}};
  for (const TradeoffStretch& s : stretches)
    rows.push_back({number_text(s.to), plain_length(s.at_from.middle()), plain_length(s.at_to.middle()),
                    stretch_end_text(s, gates)});
  std::array<std::size_t, 3> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string out;
  for (const Row& row : rows)
    out += fmt::format("{:>{}}  {:>{}}  {:>{}}  {}\n", row[0], widths[0], row[1], widths[1], row[2], widths[2], row[3]);
  return out;
}

}  // namespace taut
