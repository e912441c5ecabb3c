// Values of the plane as JSON, for everything that writes results.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/search/prm_planner.h>

namespace taut::detail {

inline nlohmann::ordered_json json_of(Point p) { return {p.x, p.y}; }
inline nlohmann::ordered_json json_of(const Segment& s) { return {json_of(s.a), json_of(s.b)}; }

inline nlohmann::ordered_json json_of(const PrmConnectivity& c) {
  return {{"samples", c.counts.drawn},         {"vertices", c.counts.kept},
          {"edges", c.counts.edges},           {"edges_tested", c.counts.edges_tested},
          {"components", c.counts.components}, {"start_part", c.start_part},
          {"goal_part", c.goal_part}};
}

template <typename Value>
nlohmann::ordered_json json_of(const std::vector<Value>& values) {
  auto array = nlohmann::ordered_json::array();
  for (const Value& value : values) array.push_back(json_of(value));
  return array;
}

/// Indented, but arrays that hold no object on one line each level of two: `[[0.5, 1], [3, 4]]`. Ends in a newline.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace taut::detail
