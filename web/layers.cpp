// What can be drawn below a path.
#include <fmt/format.h>

#include <taut/roadmaps/visibility_graph.h>
#include <taut/web/detail/answers.h>

namespace taut::web {

namespace {

constexpr std::size_t kMostCorners = 20'000;  // of a visibility graph: more would take minutes, and be a black page
constexpr std::size_t kMostEdges = 400'000;
constexpr std::size_t kMostConstraints = 150'000;  // of a Voronoi diagram

[[noreturn]] void too_much(std::size_t count, const char* of, const char* layer) {
  throw InputError("", 0, fmt::format("{} {} are too many for a picture of {}", count, of, layer));
}

Json triangulation_layer(const FreeSpace& space) {
  const Triangulation& tri = space.triangulation();
  Flat out;
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t n = tri.neighbours[t][i];
      if (!tri.free[t] || tri.is_constrained(t, i) || (n != kNone && tri.free[n] && n < t)) continue;
      const auto& corners = tri.triangles[t];
      out << Segment{tri.points[corners[Triangulation::ccw(i)]], tri.points[corners[Triangulation::cw(i)]]};
    }
  return {{"segments", out.json()}};
}

Json mesh_layer(const Navmesh& mesh) {
  Flat out;
  for (std::uint32_t c = 0; c < mesh.corners.size(); ++c) {
    const Navmesh::Corner& corner = mesh.corners[c];
    if (corner.across != kNone && c < corner.across) out << Segment{corner.point, mesh.corners[mesh.next(c)].point};
  }
  return {{"segments", out.json()}};
}

Json visibility_layer(const FreeSpace& space) {
  const auto& sectors = space.triangulation().sectors;
  const auto corners = static_cast<std::size_t>(
      std::ranges::count_if(sectors, [](const Triangulation::Sector& sector) { return sector.reflex; }));
  if (corners > kMostCorners) too_much(corners, "corners", "the visibility graph");
  const VisibilityGraph graph(space);
  const Roadmap& roadmap = graph.roadmap();
  if (roadmap.edge_count() > kMostEdges) too_much(roadmap.edge_count(), "edges", "the visibility graph");
  Flat out;
  for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v)
    for (const Roadmap::Vertex w : roadmap.neighbours(v))
      if (v < w) out << Segment{roadmap.point(v), roadmap.point(w)};
  return {{"segments", out.json()}};
}

Json gates_layer(const Gates& gates) {
  Flat segments, widths;
  for (const Gate& gate : gates.gates()) {
    if (gate.to_opening) continue;
    segments << Segment{gate.end, gate.foot};
    widths << gate.width;
  }
  return {{"segments", segments.json()}, {"widths", widths.json()}};
}

Json region_layer(const Ground& ground, const Request& request) {
  const std::optional<Point> at = request.point("at");
  const Point p = at ? *at : query_of(ground, request).start;
  if (!ground.space().holds(p)) throw InputError("", 0, "nothing is seen from within a wall");
  return {{"ring", flat(ground.space().visibility_polygon(p).ring)}};
}

}  // namespace

Json layer_answer(Ground& ground, const Request& request) {
  const std::string name = request.text("name").value_or("");
  if (name == "triangulation") return triangulation_layer(ground.space());
  if (name == "mesh") return mesh_layer(ground.mesh());
  if (name == "visibility") return visibility_layer(ground.space());
  if (name == "gates") return gates_layer(ground.gates());
  if (name == "region") return region_layer(ground, request);
  if (name != "voronoi") throw InputError("", 0, "there is no layer '" + name + "'");
  const std::size_t pieces = ground.space().constraints().size();
  if (pieces > kMostConstraints) too_much(pieces, "pieces of wall", "the Voronoi diagram");
  return voronoi_layer(ground.space());
}

}  // namespace taut::web
