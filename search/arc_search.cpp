#include <taut/search/arc_search.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

#include <taut/roadmaps/exact/tangent_parts.h>

namespace taut {

namespace {

/// The way from a query's end to a tangent point. `side` is the one it has the circle's centre on, seen in the
/// direction of the path.
struct EndLeg {
  std::uint32_t point;
  int side;
  Interval length;
};

class ArcQuery {
 public:
  ArcQuery(const TangentParts& graph, Point s, Point g)
      : graph_(graph), s_(s), g_(g), points_(graph.points), site_of_(graph.site_of) {}

  ArcSearchResult search() {
    join();
    labels_.assign(2 * points_.size() + 1, {});
    end_ = static_cast<std::uint32_t>(2 * points_.size());
    start();
    ArcSearchResult result;
    while (!open_.empty()) {
      const Open next = open_.top();
      if (labels_[end_].found && next.least > labels_[end_].length.hi) break;
      open_.pop();
      if (next.node == end_ || next.version != labels_[next.node].version) continue;
      ++result.expanded;
      expand(next.node);
    }
    if (!labels_[end_].found) return result;
    result.status = DiscStatus::found;
    result.path = path();
    return result;
  }

 private:
  static constexpr std::uint32_t kStart = kNone;

  struct Label {
    Interval length;
    std::uint32_t before = kStart;
    std::uint32_t version = 0;
    bool found = false;
  };
  struct Open {
    double least;
    std::uint32_t node;
    std::uint32_t version;
    bool operator<(const Open& other) const { return least != other.least ? least > other.least : node > other.node; }
  };

  TangentSite site_for(Point p) const {
    TangentSite site{p, kNone, kNone, false, {}};
    const Location at = graph_.walls.space().locate(p);
    if (at.kind != Location::Kind::vertex) return site;
    const Triangulation& tri = graph_.walls.walls().triangulation();
    site.vertex = tri.triangles[at.triangle][at.index];
    site.sector = tri.sector_of[3 * at.triangle + static_cast<std::uint32_t>(at.index)];
    return site;
  }

  std::vector<EndLeg> legs_of(const TangentSite& end, bool to) {
    std::vector<EndLeg> result;
    for (const std::uint32_t v : graph_.walls.seen_from(end.at)) {
      const std::uint32_t j = graph_.site_at[v];
      if (j == kNone || graph_.sites[j].at == end.at) continue;
      for (const TangentPair& pair : free_tangents(graph_.walls, graph_.r, end, graph_.sites[j])) {
        const int side = to ? pair.to.here.side : -pair.to.here.side;
        result.push_back({static_cast<std::uint32_t>(points_.size()), side, pair.length});
        points_.push_back(pair.to);
        site_of_.push_back(j);
      }
    }
    return result;
  }

  /// Adds the ends' tangents and orders the circles they touch anew.
  void join() {
    const TangentSite from = site_for(s_), to = site_for(g_);
    from_start_ = legs_of(from, false);
    to_goal_ = legs_of(to, true);
    const TangentLine line({s_, 0}, {g_, 0}, graph_.r);
    if (graph_.walls.is_free(line, from.sector, to.sector)) direct_ = line.length();
    std::map<std::uint32_t, std::vector<std::uint32_t>> added;
    for (auto p = static_cast<std::uint32_t>(graph_.points.size()); p < points_.size(); ++p)
      added[site_of_[p]].push_back(p);
    same_.resize(points_.size() - graph_.points.size());
    for (const auto& [site, more] : added) rings_[site] = ring_with(site, more);
    for (std::vector<EndLeg>* legs : {&from_start_, &to_goal_})
      for (EndLeg& leg : *legs) leg.point = same_[leg.point - graph_.points.size()];
    for (const EndLeg& leg : to_goal_) goal_legs_[node(leg.point, leg.side)] = leg.length;
  }

  TangentRing ring_with(std::uint32_t site, const std::vector<std::uint32_t>& more) {
    TangentRing ring{graph_.rings[site].points, {}};
    ring.points.insert(ring.points.end(), more.begin(), more.end());
    const bool round = graph_.sites[site].round;
    if (round) sort_around(ring.points, points_, graph_.sites[site]);
    std::size_t kept = 0;
    for (const std::uint32_t p : ring.points) {
      const bool repeated = kept > 0 && (!round || same_point(points_[ring.points[kept - 1]], points_[p]));
      if (!repeated) ring.points[kept++] = p;
      if (p >= graph_.points.size()) same_[p - graph_.points.size()] = ring.points[kept - 1];
    }
    ring.points.resize(kept);
    if (!round || kept < 2) return ring;
    const CircleObstacles obstacles = graph_.walls.around(graph_.sites[site].at);
    for (std::size_t k = 0; k + 1 < kept; ++k)
      ring.free.push_back(graph_.walls.arc_is_free(points_[ring.points[k]], points_[ring.points[k + 1]], obstacles));
    return ring;
  }

  static std::uint32_t node(std::uint32_t point, int side) { return 2 * point + (side > 0); }

  const TangentRing& ring(std::uint32_t site) const {
    const auto own = rings_.find(site);
    return own == rings_.end() ? graph_.rings[site] : own->second;
  }

  double estimate(std::uint32_t n) const {
    if (n == end_) return 0;
    const TangentPoint& p = points_[n / 2];
    const double r = p.here.side == 0 ? 0 : graph_.r;
    const double x = p.here.centre.x + r * p.x.middle() - g_.x, y = p.here.centre.y + r * p.y.middle() - g_.y;
    const double far = std::hypot(x, y);
    return std::max(0.0, far - 1e-13 * (far + std::abs(g_.x) + std::abs(g_.y)));
  }

  void reach(std::uint32_t n, const Interval& length, std::uint32_t before) {
    Label& label = labels_[n];
    if (label.found && length.hi >= label.length.lo) return;
    label = {length, before, label.version + 1, true};
    open_.push({std::max(0.0, length.lo) + estimate(n), n, label.version});
  }

  void start() {
    if (direct_) reach(end_, *direct_, kStart);
    for (const EndLeg& leg : from_start_) reach(node(leg.point, leg.side), leg.length, kStart);
  }

  void expand(std::uint32_t n) {
    const std::uint32_t p = n / 2, site = site_of_[p];
    const Interval so_far = labels_[n].length;
    const bool round = graph_.sites[site].round;
    const int side = round ? (n % 2 == 1 ? 1 : -1) : 0;
    if (const auto goal = goal_legs_.find(n); goal != goal_legs_.end()) reach(end_, so_far + goal->second, n);
    if (p < graph_.points.size())
      for (std::uint32_t i = graph_.first_leg[p]; i < graph_.first_leg[p + 1]; ++i) {
        const TangentLeg& leg = graph_.legs[i];
        if (leg.from_side == side) reach(node(leg.to, leg.to_side), so_far + leg.length, n);
      }
    if (round) follow_arc(p, site, side, so_far);
  }

  void follow_arc(std::uint32_t p, std::uint32_t site, int side, const Interval& so_far) {
    const TangentRing& all = ring(site);
    const auto at = static_cast<std::size_t>(std::find(all.points.begin(), all.points.end(), p) - all.points.begin());
    if (side < 0 && at == 0) return;
    const std::size_t arc = side > 0 ? at : at - 1;
    if (arc >= all.free.size() || !all.free[arc]) return;
    const std::uint32_t next = all.points[side > 0 ? at + 1 : at - 1];
    reach(node(next, side), so_far + Interval(graph_.r) * angle_between(points_[p], points_[next]), node(p, side));
  }

  ArcPath path() const {
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t n = labels_[end_].before; n != kStart; n = labels_[n].before) nodes.push_back(n);
    std::reverse(nodes.begin(), nodes.end());
    ArcPath path{graph_.r, s_, g_, {}, {}};
    for (std::size_t i = 0, k; i < nodes.size(); i = k + 1) {
      // A stay on one circle: from its first point to its last.
      const std::uint32_t site = site_of_[nodes[i] / 2];
      for (k = i; k + 1 < nodes.size() && site_of_[nodes[k + 1] / 2] == site;) ++k;
      const TangentSite& corner = graph_.sites[site];
      if (corner.round && k == i) continue;
      path.bends.push_back({corner.at, !corner.round ? 0 : nodes[i] % 2 == 1 ? 1 : -1});
    }
    path.length = length_of(pieces(path));
    return path;
  }

  const TangentParts& graph_;
  Point s_, g_;
  std::vector<TangentPoint> points_;
  std::vector<std::uint32_t> site_of_;
  std::vector<std::uint32_t> same_;  // of each added point
  std::map<std::uint32_t, TangentRing> rings_;
  std::vector<EndLeg> from_start_, to_goal_;
  std::map<std::uint32_t, Interval> goal_legs_;
  std::optional<Interval> direct_;
  std::vector<Label> labels_;
  std::priority_queue<Open> open_;
  std::uint32_t end_ = 0;
};

}  // namespace

ArcSearchResult arc_search(const TangentGraph& graph, Point s, Point g) {
  const TangentWalls& walls = graph.parts().walls;
  const auto blocked = [&](Point p, DiscStatus status) -> std::optional<ArcSearchResult> {
    if (walls.space().locate(p).kind == Location::Kind::outside) return ArcSearchResult{status, {}, kNone, 0};
    const std::uint32_t wall = walls.too_near(p);
    if (wall == kNone) return std::nullopt;
    return ArcSearchResult{status, {}, wall, 0};
  };
  if (auto at_start = blocked(s, DiscStatus::start_blocked)) return *at_start;
  if (auto at_goal = blocked(g, DiscStatus::goal_blocked)) return *at_goal;
  if (s == g) return {DiscStatus::found, {graph.radius(), s, g, {}, {}}, kNone, 0};
  return ArcQuery(graph.parts(), s, g).search();
}

}  // namespace taut
