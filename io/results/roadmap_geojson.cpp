#include <fmt/format.h>

#include <iterator>
#include <utility>

#include <taut/geometry/length.h>
#include <taut/io/results/roadmap_export.h>

namespace taut {

// Written by hand: a tree of millions of edges would take gigabytes.
std::string roadmap_geojson(const Roadmap& roadmap) {
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "{{\"type\": \"FeatureCollection\", \"features\": [");
  const char* separator = "\n";
  for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v)
    fmt::format_to(put,
                   "{}{{\"type\": \"Feature\", \"properties\": {{\"vertex\": {}}}, "
                   "\"geometry\": {{\"type\": \"Point\", \"coordinates\": [{}, {}]}}}}",
                   std::exchange(separator, ",\n"), v, roadmap.point(v).x, roadmap.point(v).y);
  for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v)
    for (const Roadmap::Vertex w : roadmap.neighbours(v)) {
      if (w < v) continue;
      const Point a = roadmap.point(v), b = roadmap.point(w);
      fmt::format_to(put,
                     "{}{{\"type\": \"Feature\", \"properties\": {{\"from\": {}, \"to\": {}, \"length\": {}}}, "
                     "\"geometry\": {{\"type\": \"LineString\", \"coordinates\": [[{}, {}], [{}, {}]]}}}}",
                     std::exchange(separator, ",\n"), v, w, distance_interval(a, b).lo, a.x, a.y, b.x, b.y);
    }
  fmt::format_to(put, "\n]}}\n");
  return {out.data(), out.size()};
}

}  // namespace taut
