#include <taut/search/detail/arc_ends.h>

#include <algorithm>

namespace taut::detail {

namespace {

class Joining {
 public:
  Joining(const ArcGraph& graph, Point s, Point g)
      : graph_(graph), s_(end_site(graph.ground.walls, s)), g_(end_site(graph.ground.walls, g)) {}

  ArcEnds join() {
    ends_.from_start = legs_of(s_, false);
    ends_.to_goal = legs_of(g_, true);
    const TangentLine line({s_.at, 0}, {g_.at, 0}, graph_.r);
    if (walls().is_free(line, s_.sector, g_.sector)) ends_.apart.push_back({line.length()});
    for (std::uint32_t i = 0; i < ends_.from_start.size(); ++i) enter(i, ends_.from_start[i], false);
    for (std::uint32_t i = 0; i < ends_.to_goal.size(); ++i) enter(i, ends_.to_goal[i], true);
    for (std::uint32_t i = 0; i < ends_.from_start.size(); ++i)
      for (std::uint32_t j = 0; j < ends_.to_goal.size(); ++j) join_apart(i, j);
    return std::move(ends_);
  }

 private:
  const TangentWalls& walls() const { return graph_.ground.walls; }

  std::vector<ArcEndLeg> legs_of(const TangentSite& end, bool to) const {
    std::vector<ArcEndLeg> result;
    for (const std::uint32_t v : walls().seen_from(end.at)) {
      const std::uint32_t j = graph_.ground.site_at[v];
      if (j == kNone) continue;
      const TangentSite& site = graph_.ground.sites[j];
      if (site.at == end.at) continue;
      if (!site.cones.reaching(graph_.r).may_lead({end.at.x - site.at.x, end.at.y - site.at.y})) continue;
      for (const TangentPair& pair : free_tangents(walls(), graph_.r, end, site, true))
        result.push_back({j, to ? pair.to.here.side : -pair.to.here.side, pair.to, pair.length});
    }
    return result;
  }

  const CircleObstacles& around(std::uint32_t site) {
    if (around_ != site) obstacles_ = walls().around(graph_.ground.sites[site].at, graph_.r);
    around_ = site;
    return obstacles_;
  }

  /// From the leg's tangent point on in the path's direction, or for the goal's back from it.
  void enter(std::uint32_t number, const ArcEndLeg& leg, bool to) {
    std::vector<ArcExit>& doors = to ? ends_.exits : ends_.entries;
    const ArcGraph::Points here = graph_.points_of(leg.site);
    const std::span<const TangentPoint> all = here.all;
    const TangentSite& site = graph_.ground.sites[leg.site];
    if (all.empty()) return;
    if (!site.round) return doors.push_back({arc_node(here.first, 0), leg.length, number, false});
    std::uint32_t at = 0;
    while (at < all.size() && is_before(all[at], leg.point, site)) ++at;
    if (at < all.size() && same_point(all[at], leg.point))
      return doors.push_back({arc_node(here.first + at, leg.side), leg.length, number, false});
    const bool upwards = (leg.side > 0) != to;
    if (at == (upwards ? all.size() : 0)) return;
    const std::uint32_t next = upwards ? at : at - 1;
    const TangentPoint &low = upwards ? leg.point : all[next], &high = upwards ? all[next] : leg.point;
    if (walls().arc_is_free(low, high, around(leg.site)))
      doors.push_back({arc_node(here.first + next, leg.side), leg.length + arc(low, high), number, true});
  }

  void join_apart(std::uint32_t i, std::uint32_t j) {
    const ArcEndLeg &in = ends_.from_start[i], &out = ends_.to_goal[j];
    if (in.site != out.site || in.side != out.side) return;
    const TangentSite& site = graph_.ground.sites[in.site];
    if (!site.round || same_point(in.point, out.point))
      return ends_.apart.push_back({in.length + out.length, i, j, !site.round});
    const TangentPoint &low = in.side > 0 ? in.point : out.point, &high = in.side > 0 ? out.point : in.point;
    if (is_before(low, high, site) && walls().arc_is_free(low, high, around(in.site)))
      ends_.apart.push_back({in.length + arc(low, high) + out.length, i, j, true});
  }

  Interval arc(const TangentPoint& from, const TangentPoint& to) const {
    return Interval(graph_.r) * angle_between(from, to);
  }

  const ArcGraph& graph_;
  TangentSite s_, g_;
  ArcEnds ends_;
  CircleObstacles obstacles_;
  std::uint32_t around_ = kNone;
};

}  // namespace

TangentSite end_site(const TangentWalls& walls, Point p) {
  TangentSite site{p, kNone, kNone, false, {}};
  const Location at = walls.space().locate(p);
  if (at.kind != Location::Kind::vertex) return site;
  const Triangulation& tri = walls.walls().triangulation();
  site.vertex = tri.triangles[at.triangle][at.index];
  site.sector = tri.sector_of[3 * at.triangle + static_cast<std::uint32_t>(at.index)];
  return site;
}

ArcEnds join_ends(const ArcGraph& graph, Point s, Point g) { return Joining(graph, s, g).join(); }

ArcEnds join_ends(const TangentParts& graph, Point s, Point g) {
  const auto points_of = [&](std::uint32_t i) {
    const std::uint32_t first = graph.first_point[i];
    return ArcGraph::Points{first, std::span(graph.points).subspan(first, graph.first_point[i + 1] - first)};
  };
  return join_ends({*graph.ground, graph.r, points_of}, s, g);
}

}  // namespace taut::detail
