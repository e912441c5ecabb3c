#include <taut/io/results/alternatives_json.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include <taut/io/results/plane_json.h>
#include <taut/io/results/words.h>
#include <taut/search/corner_count.h>

namespace taut {

namespace {

Json way_json(const Alternative& way) {
  const Interval length = way.path.length.interval();
  Json json = {{"length", way.path.length.value()},
               {"length_interval", {length.lo, length.hi}},
               {"points", way.path.points},
               {"corners", corner_count(way.path.points)},
               {"width", nullptr},
               {"width_text", nullptr},
               {"posts", nullptr}};
  if (!way.gate) return json;
  json["width"] = way.gate->width;
  json["width_text"] = way.gate->width_text;
  json["posts"] = way.gate->at;
  return json;
}

}  // namespace

Json alternatives_json(const AlternativesAnswer& answer) {
  Json ways = Json::array();
  for (const Alternative& way : answer.found.ways) ways.push_back(way_json(way));
  Json json = {{"query", "alternatives"},
               {"asked", answer.wider ? Json("wider") : Json(answer.asked)},
               {"all", answer.found.all},
               {"alternatives", ways},
               {"verified", answer.verified}};
  if (answer.within) json["within"] = *answer.within;
  json["start"] = answer.start;
  json["goal"] = {{"point", answer.goal}};
  json["robot"] = robot_json(Footprint::point());
  return json;
}

std::string alternatives_table(const Alternatives& found) {
  using Row = std::array<std::string, 4>;
  std::vector<Row> rows{{"", "length", "longer by", "narrowest"}};
  for (std::size_t i = 0; i < found.ways.size(); ++i) {
    const Alternative& way = found.ways[i];
    const double more = way.path.length.value() - found.ways.front().path.length.value();
    rows.push_back({fmt::format("{}", i + 1), length_text(way.path.length), fmt::format("{:.6f}", more),
                    way.gate ? way.gate->name : "no gate"});
  }
  Row::size_type widths[3] = {};
  for (const Row& row : rows)
    for (std::size_t k = 0; k < 3; ++k) widths[k] = std::max(widths[k], row[k].size());
  std::string out;
  for (const Row& row : rows)
    out += fmt::format("{:>{}}  {:>{}}  {:>{}}  {}\n", row[0], widths[0], row[1], widths[1], row[2], widths[2], row[3]);
  return out;
}

}  // namespace taut
