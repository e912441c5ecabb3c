#include <fmt/format.h>

#include <cmath>

#include <taut/io/results/detail/long_list.h>
#include <taut/io/results/voronoi_export.h>

namespace taut {

namespace {

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

Json voronoi_json(const VoronoiRoadmap& map) {
  detail::LongList vertices, edges, clearances, arcs;
  for (const VoronoiVertex& v : map.vertices()) {
    vertices.add("{}", text_of(v.at));
    clearances.add("{}", std::sqrt(v.clearance_squared));
  }
  for (const VoronoiEdge& e : map.edges()) {
    edges.add("[{}, {}]", e.from, e.to);
    arcs.add("{}", arc_of(map, e));
  }
  return {{"kind", "segment Voronoi diagram"}, {"max_error", map.max_error()},
          {"vertices", vertices.json()},       {"edges", edges.json()},
          {"clearances", clearances.json()},   {"arcs", arcs.json()}};
}

}  // namespace taut
