#include <taut/search/cell_search.h>

#include <algorithm>
#include <cmath>

#include <taut/search/detail/room_entries.h>
#include <taut/search/query_ends.h>

namespace taut {

namespace {

bool share_a_cell(const CellLattice& lattice, Point p, Point q) {
  const std::vector<Cell> at_p = lattice.cells_at(p), at_q = lattice.cells_at(q);
  return std::find_first_of(at_p.begin(), at_p.end(), at_q.begin(), at_q.end()) != at_p.end();
}

bool is_in_room(const FreeSpace& space, Point from, const std::vector<Box>& room) {
  return std::any_of(room.begin(), room.end(),
                     [&](const Box& box) { return box.contains(from) && space.sees(from, detail::middle(box)); });
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

}  // namespace

GraphSearchResult cell_search(const CellGraph& graph, Point from, const Goal& to, GraphAlgorithm algorithm,
                              const SearchLimits& limits) {
  require_free(graph.space(), from, "start");
  if (to.point) require_free(graph.space(), *to.point, "goal");
  if (!to.point && is_in_room(graph.space(), from, to.room)) {
    GraphSearchResult result;
    result.status = SearchStatus::found;
    result.path.points = {from};
    return result;
  }
  return graph_search(graph.roadmap(), to.point ? to_point(graph, from, *to.point) : to_room(graph, from, to.room),
                      algorithm, limits);
}

}  // namespace taut
