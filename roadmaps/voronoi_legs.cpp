#include <taut/roadmaps/voronoi_legs.h>

#include <utility>
#include <vector>

namespace taut {

namespace {

/// All vertices, or those that the edges join.
std::vector<std::uint32_t> numbers_of_vertices(const VoronoiRoadmap& map, double clearance) {
  std::vector<std::uint32_t> number(map.vertices().size(), clearance > 0 ? kNone : 0);
  for (const VoronoiEdge& e : map.edges())
    if (e.clearance >= clearance) number[e.from] = number[e.to] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t& n : number)
    if (n != kNone) n = count++;
  return number;
}

}  // namespace

Roadmap voronoi_legs(const VoronoiRoadmap& map, double tolerance, double clearance) {
  const std::vector<std::uint32_t> number = numbers_of_vertices(map, clearance);
  std::vector<Point> points;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != kNone) points.push_back(map.vertices()[v].at);
  std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>> legs;
  for (const VoronoiEdge& e : map.edges()) {
    if (e.clearance < clearance) continue;
    Roadmap::Vertex last = number[e.from];
    if (e.kind == VoronoiEdge::Kind::parabola) {
      const std::vector<Point> on_arc = sampled({map.curve(e)}, tolerance);
      for (std::size_t i = 1; i + 1 < on_arc.size(); ++i) {
        const auto next = static_cast<Roadmap::Vertex>(points.size());
        points.push_back(on_arc[i]);
        legs.emplace_back(last, next);
        last = next;
      }
    }
    legs.emplace_back(last, number[e.to]);
  }
  return Roadmap(std::move(points), legs);
}

}  // namespace taut
