#include <taut/search/cell_search.h>

#include <algorithm>
#include <cmath>

#include <taut/search/detail/room_entries.h>

namespace taut {

namespace {

bool share_a_cell(const CellLattice& lattice, Point p, Point q) {
  const std::vector<Cell> at_p = lattice.cells_at(p), at_q = lattice.cells_at(q);
  return std::find_first_of(at_p.begin(), at_p.end(), at_q.begin(), at_q.end()) != at_p.end();
}

GraphQuery to_point(const CellGraph& graph, Point from, Point to) {
  GraphQuery query{{from, graph.joined_to(from)}, {{to, graph.joined_to(to)}}, {}};
  if (share_a_cell(graph.lattice(), from, to) && graph.space().sees(from, to)) query.direct.push_back(0);
  return query;
}

GraphQuery to_room(const CellGraph& graph, Point from, const std::vector<Box>& room) {
  const FreeSpace& space = graph.space();
  GraphQuery query{{from, graph.joined_to(from)}, {}, {}};
  for (const detail::RoomSide& side : detail::room_sides(room))
    for (Roadmap::Vertex v = 0; v < graph.roadmap().vertex_count(); ++v) {
      const Point centre = graph.roadmap().point(v);
      const auto foot = side.foot(centre);
      if (!foot || std::abs(foot->x - centre.x) + std::abs(foot->y - centre.y) > graph.lattice().side) continue;
      if (space.locate(*foot).kind == Location::Kind::outside || !space.sees(*foot, centre, side.inside)) continue;
      query.goals.push_back({*foot, {v}});
    }
  return query;
}

GraphQuery query_of(const CellGraph& graph, Point from, const Goal& to) {
  return to.point ? to_point(graph, from, *to.point) : to_room(graph, from, to.room);
}

}  // namespace

GraphQuery cell_query(const CellGraph& graph, Point from, const Goal& to) {
  if (detail::answer_at_start(graph.space(), from, to)) return detail::query_at_start(from);
  return query_of(graph, from, to);
}

GraphSearchResult cell_search(const CellGraph& graph, Point from, const Goal& to, GraphMethod method,
                              const SearchLimits& limits) {
  if (auto answer = detail::answer_at_start(graph.space(), from, to)) return *answer;
  return graph_search(graph.roadmap(), query_of(graph, from, to), method, limits);
}

}  // namespace taut
