#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iterator>
#include <utility>

#include <taut/io/results/voronoi_export.h>

namespace taut {

namespace {

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string text_of(Point p) { return fmt::format("[{}, {}]", p.x, p.y); }
std::string text_of(const Segment& s) { return fmt::format("[{}, {}]", text_of(s.a), text_of(s.b)); }

std::string gate_of(const VoronoiRoadmap& map, const VoronoiEdge& e) {
  if (e.gate == VoronoiEdge::Gate::none) return "null";
  const auto posts = map.posts(e);
  return text_of(Segment{posts[0], posts[1]});
}

std::string arc_of(const VoronoiRoadmap& map, const VoronoiEdge& e) {
  return fmt::format(
      "{{\"kind\": \"{}\", \"control\": {}, \"length\": {}, \"clearance\": {}, \"gate\": {}, \"sites\": [{}, {}]}}",
      e.kind == VoronoiEdge::Kind::line ? "line" : "parabola", text_of(e.control), e.length, e.clearance,
      gate_of(map, e), text_of(map.segment(e.sites[0])), text_of(map.segment(e.sites[1])));
}

}  // namespace

// Written by hand, as roadmap_json is.
std::string voronoi_json(const VoronoiRoadmap& map, const std::string& source, double seconds) {
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  const double error = map.max_error();
  fmt::format_to(put,
                 "{{\n  \"program\": \"taut\",\n  \"kind\": \"segment Voronoi diagram\",\n  \"source\": {},\n"
                 "  \"seconds\": {},\n  \"max_error\": {}",
                 quoted(source), seconds, std::isfinite(error) ? fmt::format("{}", error) : "null");
  const auto list = [&](const char* key, const auto& items, auto text) {
    fmt::format_to(put, ",\n  \"{}\": [", key);
    const char* separator = "\n    ";
    for (const auto& item : items) fmt::format_to(put, "{}{}", std::exchange(separator, ",\n    "), text(item));
    fmt::format_to(put, "\n  ]");
  };
  list("vertices", map.vertices(), [](const VoronoiVertex& v) { return text_of(v.at); });
  list("edges", map.edges(), [](const VoronoiEdge& e) { return fmt::format("[{}, {}]", e.from, e.to); });
  list("clearances", map.vertices(),
       [](const VoronoiVertex& v) { return fmt::format("{}", std::sqrt(v.clearance_squared)); });
  list("arcs", map.edges(), [&](const VoronoiEdge& e) { return arc_of(map, e); });
  fmt::format_to(put, "\n}}\n");
  return {out.data(), out.size()};
}

}  // namespace taut
