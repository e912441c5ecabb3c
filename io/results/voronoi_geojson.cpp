#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <utility>

#include <taut/io/results/voronoi_export.h>

namespace taut {

std::string voronoi_geojson(const VoronoiRoadmap& map, double tolerance) {
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "{{\"type\": \"FeatureCollection\", \"features\": [");
  const char* separator = "\n";
  for (std::size_t v = 0; v < map.vertices().size(); ++v) {
    const VoronoiVertex& vertex = map.vertices()[v];
    fmt::format_to(put,
                   "{}{{\"type\": \"Feature\", \"properties\": {{\"vertex\": {}, \"clearance\": {}}}, "
                   "\"geometry\": {{\"type\": \"Point\", \"coordinates\": [{}, {}]}}}}",
                   std::exchange(separator, ",\n"), v, std::sqrt(vertex.clearance_squared), vertex.at.x, vertex.at.y);
  }
  for (const VoronoiEdge& e : map.edges()) {
    const bool line = e.kind == VoronoiEdge::Kind::line;
    fmt::format_to(put,
                   "{}{{\"type\": \"Feature\", \"properties\": {{\"from\": {}, \"to\": {}, \"length\": {}, "
                   "\"clearance\": {}, \"kind\": \"{}\"{}}}, \"geometry\": {{\"type\": \"LineString\", "
                   "\"coordinates\": [",
                   std::exchange(separator, ",\n"), e.from, e.to, e.length, e.clearance, line ? "line" : "parabola",
                   line ? "" : fmt::format(", \"tolerance\": {}", tolerance));
    const char* comma = "";
    for (const Point p : sampled({map.curve(e)}, tolerance))
      fmt::format_to(put, "{}[{}, {}]", std::exchange(comma, ", "), p.x, p.y);
    fmt::format_to(put, "]}}}}");
  }
  fmt::format_to(put, "\n]}}\n");
  return {out.data(), out.size()};
}

}  // namespace taut
