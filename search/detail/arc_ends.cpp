#include <taut/search/detail/arc_ends.h>

#include <algorithm>

namespace taut::detail {

namespace {

class Joining {
 public:
  Joining(const TangentParts& graph, Point s, Point g) : graph_(graph), s_(site_for(s)), g_(site_for(g)) {}

  ArcEnds join() {
    ends_.from_start = legs_of(s_, false);
    ends_.to_goal = legs_of(g_, true);
    const TangentLine line({s_.at, 0}, {g_.at, 0}, graph_.r);
    if (graph_.walls().is_free(line, s_.sector, g_.sector)) ends_.apart.push_back({line.length()});
    for (std::uint32_t i = 0; i < ends_.from_start.size(); ++i) enter(i, ends_.from_start[i], false);
    for (std::uint32_t i = 0; i < ends_.to_goal.size(); ++i) enter(i, ends_.to_goal[i], true);
    for (std::uint32_t i = 0; i < ends_.from_start.size(); ++i)
      for (std::uint32_t j = 0; j < ends_.to_goal.size(); ++j) join_apart(i, j);
    return std::move(ends_);
  }

 private:
  TangentSite site_for(Point p) const {
    TangentSite site{p, kNone, kNone, false, {}};
    const Location at = graph_.walls().space().locate(p);
    if (at.kind != Location::Kind::vertex) return site;
    const Triangulation& tri = graph_.walls().walls().triangulation();
    site.vertex = tri.triangles[at.triangle][at.index];
    site.sector = tri.sector_of[3 * at.triangle + static_cast<std::uint32_t>(at.index)];
    return site;
  }

  std::vector<ArcEndLeg> legs_of(const TangentSite& end, bool to) const {
    std::vector<ArcEndLeg> result;
    for (const std::uint32_t v : graph_.walls().seen_from(end.at)) {
      const std::uint32_t j = graph_.ground->site_at[v];
      if (j == kNone) continue;
      const TangentSite& site = graph_.sites()[j];
      if (site.at == end.at) continue;
      if (!site.cones.reaching(graph_.r).may_lead({end.at.x - site.at.x, end.at.y - site.at.y})) continue;
      for (const TangentPair& pair : free_tangents(graph_.walls(), graph_.r, end, site, true))
        result.push_back({j, to ? pair.to.here.side : -pair.to.here.side, pair.to, pair.length});
    }
    return result;
  }

  const CircleObstacles& around(std::uint32_t site) {
    if (around_ != site) obstacles_ = graph_.walls().around(graph_.sites()[site].at, graph_.r);
    around_ = site;
    return obstacles_;
  }

  /// From the leg's tangent point on in the path's direction, or for the goal's back from it.
  void enter(std::uint32_t number, const ArcEndLeg& leg, bool to) {
    std::vector<ArcExit>& doors = to ? ends_.exits : ends_.entries;
    const std::uint32_t first = graph_.first_point[leg.site], end = graph_.first_point[leg.site + 1];
    const TangentSite& site = graph_.sites()[leg.site];
    if (first == end) return;
    if (!site.round) return doors.push_back({arc_node(first, 0), leg.length, number, false});
    std::uint32_t at = first;
    while (at < end && is_before(graph_.points[at], leg.point, site)) ++at;
    if (at < end && same_point(graph_.points[at], leg.point))
      return doors.push_back({arc_node(at, leg.side), leg.length, number, false});
    const bool upwards = (leg.side > 0) != to;
    if (at == (upwards ? end : first)) return;
    const std::uint32_t next = upwards ? at : at - 1;
    const TangentPoint &low = upwards ? leg.point : graph_.points[next],
                       &high = upwards ? graph_.points[next] : leg.point;
    if (graph_.walls().arc_is_free(low, high, around(leg.site)))
      doors.push_back({arc_node(next, leg.side), leg.length + arc(low, high), number, true});
  }

  void join_apart(std::uint32_t i, std::uint32_t j) {
    const ArcEndLeg &in = ends_.from_start[i], &out = ends_.to_goal[j];
    if (in.site != out.site || in.side != out.side) return;
    const TangentSite& site = graph_.sites()[in.site];
    if (!site.round || same_point(in.point, out.point))
      return ends_.apart.push_back({in.length + out.length, i, j, !site.round});
    const TangentPoint &low = in.side > 0 ? in.point : out.point, &high = in.side > 0 ? out.point : in.point;
    if (is_before(low, high, site) && graph_.walls().arc_is_free(low, high, around(in.site)))
      ends_.apart.push_back({in.length + arc(low, high) + out.length, i, j, true});
  }

  Interval arc(const TangentPoint& from, const TangentPoint& to) const {
    return Interval(graph_.r) * angle_between(from, to);
  }

  const TangentParts& graph_;
  TangentSite s_, g_;
  ArcEnds ends_;
  CircleObstacles obstacles_;
  std::uint32_t around_ = kNone;
};

}  // namespace

ArcEnds join_ends(const TangentParts& graph, Point s, Point g) { return Joining(graph, s, g).join(); }

}  // namespace taut::detail
