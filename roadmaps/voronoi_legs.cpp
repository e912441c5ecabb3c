#include <taut/roadmaps/voronoi_legs.h>

#include <utility>
#include <vector>

namespace taut {

Roadmap voronoi_legs(const VoronoiRoadmap& map, double tolerance) {
  std::vector<Point> points;
  for (const VoronoiVertex& v : map.vertices()) points.push_back(v.at);
  std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>> legs;
  for (const VoronoiEdge& e : map.edges()) {
    Roadmap::Vertex last = e.from;
    if (e.kind == VoronoiEdge::Kind::parabola) {
      const std::vector<Point> on_arc = sampled({map.curve(e)}, tolerance);
      for (std::size_t i = 1; i + 1 < on_arc.size(); ++i) {
        const auto next = static_cast<Roadmap::Vertex>(points.size());
        points.push_back(on_arc[i]);
        legs.emplace_back(last, next);
        last = next;
      }
    }
    legs.emplace_back(last, e.to);
  }
  return Roadmap(std::move(points), legs);
}

}  // namespace taut
