#include <taut/search/shortest_path.h>

#include <utility>

#include <taut/search/detail/room_entries.h>
#include <taut/search/polyanya.h>
#include <taut/search/query_ends.h>

namespace taut {

namespace {

GraphQuery to_point(const VisibilityGraph& graph, Point from, Point to) {
  GraphQuery query{{from, graph.visible_from(from)}, {{to, graph.visible_from(to)}}, {}};
  if (graph.space().sees(from, to)) query.direct.push_back(0);
  return query;
}

/// A place in the direction of the inside of a reflex sector.
Point beyond(const Triangulation& tri, const Triangulation::Sector& sector) {
  const Point at = tri.points[sector.vertex], right = tri.points[sector.right], left = tri.points[sector.left];
  return {3 * at.x - right.x - left.x, 3 * at.y - right.y - left.y};
}

/// Of a last leg from a vertex of the graph into a room: the last bend is a reflex sector, and the leg begins in it. Of
/// walls through a room a foot can be seen on their other side.
bool begins_in_sector(const VisibilityGraph& graph, Roadmap::Vertex v, Point p, Point foot) {
  const Triangulation& tri = graph.space().triangulation();
  const Triangulation::Sector& sector = tri.sectors[graph.sector(v)];
  return sector.reflex && !sector.full && graph.space().sees(p, foot, beyond(tri, sector));
}

/// One terminal for each place where a shortest path can enter the room.
GraphQuery to_room(const VisibilityGraph& graph, Point from, const std::vector<Box>& room) {
  const FreeSpace& space = graph.space();
  GraphQuery query{{from, graph.visible_from(from)}, {}, {}};
  for (const detail::RoomEntry& entry : detail::room_entries(space, room)) {
    if (space.sees(entry.point, from, entry.inside)) query.direct.push_back(query.goals.size());
    query.goals.push_back({entry.point, graph.visible_from(entry.point, entry.inside)});
  }
  for (const detail::RoomSide& side : detail::room_sides(room)) {
    const auto add_foot = [&](Point p, Roadmap::Vertex v) {
      const auto foot = side.foot(p);
      if (!foot || space.locate(*foot).kind == Location::Kind::outside || !space.sees(*foot, p, side.inside)) return;
      if (v != kNone && !begins_in_sector(graph, v, p, *foot)) return;
      if (v == kNone) query.direct.push_back(query.goals.size());
      query.goals.push_back({*foot, v == kNone ? std::vector<Roadmap::Vertex>{} : std::vector{v}});
    };
    add_foot(from, kNone);
    for (Roadmap::Vertex v = 0; v < graph.roadmap().vertex_count(); ++v) add_foot(graph.roadmap().point(v), v);
  }
  return query;
}

GraphQuery query_of(const VisibilityGraph& graph, Point from, const Goal& to) {
  return to.point ? to_point(graph, from, *to.point) : to_room(graph, from, to.room);
}

}  // namespace

GraphQuery visibility_query(const VisibilityGraph& graph, Point from, const Goal& to) {
  if (detail::answer_at_start(graph.space(), from, to)) return detail::query_at_start(from);
  return query_of(graph, from, to);
}

GraphSearchResult shortest_path(const VisibilityGraph& graph, Point from, const Goal& to, GraphMethod method,
                                const SearchLimits& limits) {
  if (auto answer = detail::answer_at_start(graph.space(), from, to)) return *answer;
  return graph_search(graph.roadmap(), query_of(graph, from, to), method, limits);
}

std::optional<Path> shortest_path(const FreeSpace& space, Point from, const Goal& to) {
  GraphSearchResult result = shortest_path(Polyanya::between(space, from, to), from, to);
  if (result.status != SearchStatus::found) return std::nullopt;
  return std::move(result.path);
}

std::optional<Path> shortest_path(const FreeSpace& space, Point from, Point to) {
  return shortest_path(space, from, Goal{to, {}});
}

ShortestPathTree::ShortestPathTree(std::shared_ptr<const VisibilityGraph> graph, Point from)
    : graph_((require_free(graph->space(), from, "start"), std::move(graph))),
      from_(from),
      paths_(std::shared_ptr<const Roadmap>(graph_, &graph_->roadmap()), {from, graph_->visible_from(from)}) {}

std::optional<Path> ShortestPathTree::path_to(Point to) const {
  require_free(graph_->space(), to, "goal");
  return paths_.path_to({to, graph_->visible_from(to)}, graph_->space().sees(from_, to));
}

}  // namespace taut
