#include <taut/search/detail/taut_legs.h>

#include <algorithm>

#include <taut/geometry/written.h>

namespace taut::detail {

TautLegs::TautLegs(const VisibilityGraph& graph) {
  const Roadmap& roadmap = graph.roadmap();
  const auto vertices = static_cast<Roadmap::Vertex>(roadmap.vertex_count());
  first_.reserve(vertices + std::size_t{1});
  first_.push_back(0);
  legs_.reserve(2 * roadmap.edge_count());
  low_.reserve(2 * roadmap.edge_count());
  for (Roadmap::Vertex v = 0; v < vertices; ++v) {
    add_legs(graph, v);
    first_.push_back(legs_.size());
  }
  turns_.reserve(legs_.size());
  for (Roadmap::Vertex v = 0; v < vertices; ++v)
    for (std::size_t e = first_[v]; e < first_[v + 1]; ++e) turns_.push_back(turns_of(graph, v, legs_[e].to));
}

void TautLegs::add_legs(const VisibilityGraph& graph, Roadmap::Vertex v) {
  const Roadmap& roadmap = graph.roadmap();
  const Triangulation& tri = graph.space().triangulation();
  const Point at = roadmap.point(v), right = tri.points[tri.sectors[graph.sector(v)].right];
  // Within half a turn from the ray to `right` or beyond. Exact, as sides of lines through two given points are.
  const auto is_beyond = [&](Point p) {
    const int side = written::orientation(at, right, p);
    return side < 0 || (side == 0 && written::on_segment(at, right, p));
  };
  std::vector<Roadmap::Vertex> row(roadmap.neighbours(v).begin(), roadmap.neighbours(v).end());
  std::stable_sort(row.begin(), row.end(), [&](Roadmap::Vertex a, Roadmap::Vertex b) {
    const Point p = roadmap.point(a), q = roadmap.point(b);
    const bool p_beyond = is_beyond(p), q_beyond = is_beyond(q);
    return p_beyond != q_beyond ? q_beyond : written::orientation(at, p, q) > 0;
  });
  // Around the free end of a wall, legs along the wall may run on either side of it: they are first and last.
  if (const auto& sector = tri.sectors[graph.sector(v)]; sector.right == sector.left)
    for (std::size_t i = 0, size = row.size(); i < size; ++i)
      if (!is_beyond(roadmap.point(row[i])) && written::orientation(at, right, roadmap.point(row[i])) == 0)
        row.push_back(row[i]);
  for (const Roadmap::Vertex to : row) {
    const twofold::Pair length = leg_of(at, roadmap.point(to));
    legs_.push_back({length.high, to});
    low_.push_back(length.low);
  }
}

TautLegs::Turns TautLegs::turns_of(const VisibilityGraph& graph, Roadmap::Vertex from, Roadmap::Vertex at) const {
  const Triangulation& tri = graph.space().triangulation();
  const Triangulation::Sector& sector = tri.sectors[graph.sector(at)];
  const Point p = graph.roadmap().point(from), q = graph.roadmap().point(at);
  const auto side = [&](Point next) { return written::orientation(p, q, next); };
  const int right = side(tri.points[sector.right]), left = side(tri.points[sector.left]);
  const std::size_t first = first_[at], last = first_[at + 1];
  std::size_t right_end = first, left_begin = last;
  if (right <= 0 && left <= 0)
    while (right_end < last && side(graph.roadmap().point(legs_[right_end].to)) <= 0) ++right_end;
  if (right >= 0 && left >= 0)
    while (left_begin > right_end && side(graph.roadmap().point(legs_[left_begin - 1].to)) >= 0) --left_begin;
  return {static_cast<std::uint32_t>(right_end - first), static_cast<std::uint32_t>(left_begin - first)};
}

}  // namespace taut::detail
