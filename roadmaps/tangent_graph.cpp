#include <taut/roadmaps/tangent_graph.h>

#include <algorithm>
#include <numeric>

#include <taut/geometry/expects.h>
#include <taut/geometry/written.h>
#include <taut/roadmaps/exact/tangent_parts.h>

namespace taut {

namespace {

using Tri = Triangulation;

/// The first and last of directions that lie in an open half-plane, counter-clockwise; nothing when they do not.
std::optional<std::array<Point, 2>> hull_of(Point c, const std::vector<Point>& ends) {
  for (const Point first : ends) {
    const auto is_left = [&](Point p) { return p == first || written::orientation(c, first, p) > 0; };
    if (!std::all_of(ends.begin(), ends.end(), is_left)) continue;
    const Point last = *std::max_element(ends.begin(), ends.end(),
                                         [&](Point p, Point q) { return written::orientation(c, p, q) > 0; });
    return std::array{first, last};
  }
  return std::nullopt;
}

/// Is some free triangle at the vertex outside the angle that its walls span?
bool is_free_beyond(const WallIndex& walls, std::uint32_t v, const std::array<Point, 2>& hull) {
  const Tri& tri = walls.triangulation();
  const Point c = tri.points[v];
  const auto around = walls.around(v);
  return std::any_of(around.begin(), around.end(), [&](std::uint32_t t) {
    if (!tri.free[t]) return false;
    const int i = tri.corner(t, v);
    const Point a = tri.points[tri.triangles[t][Tri::ccw(i)]], b = tri.points[tri.triangles[t][Tri::cw(i)]];
    return written::orientation(c, hull[0], a) < 0 || written::orientation(c, b, hull[1]) < 0;
  });
}

bool clears_own_walls(const TangentLine& line, const TangentSite& site, bool second) {
  return std::all_of(site.walls.begin(), site.walls.end(),
                     [&](Point w) { return line.clears_own(site.at, w, second); });
}

}  // namespace

std::vector<TangentPair> free_tangents(const TangentWalls& walls, double r, const TangentSite& from,
                                       const TangentSite& to) {
  std::vector<TangentPair> result;
  static constexpr std::array kRound{1, -1};
  static constexpr std::array kPoint{0};
  const auto sides = [](const TangentSite& site) {
    return site.round ? std::span<const int>(kRound) : std::span<const int>(kPoint);
  };
  for (const int s : sides(from))
    for (const int t : sides(to)) {
      const TangentEnd here{from.at, s}, there{to.at, t};
      const TangentLine line(here, there, r);
      if (!line.exists() || !clears_own_walls(line, from, false) || !clears_own_walls(line, to, true)) continue;
      if (!walls.is_free(line, from.sector, to.sector)) continue;
      result.push_back({TangentPoint(here, there, r), TangentPoint({to.at, -t}, {from.at, -s}, r), line.length()});
    }
  return result;
}

bool same_point(const TangentPoint& a, const TangentPoint& b) { return cross_sign(a, b) == 0 && dot_sign(a, b) > 0; }

void sort_around(std::vector<std::uint32_t>& points, const std::vector<TangentPoint>& all, const TangentSite& site) {
  // All lie within 180 degrees; of two opposite ones the first is a left turn from the wall between them.
  const PlainDirection wall{site.at, site.walls.front(), 0};
  std::stable_sort(points.begin(), points.end(), [&](std::uint32_t p, std::uint32_t q) {
    const int turn = cross_sign(all[p], all[q]);
    if (turn != 0 || dot_sign(all[p], all[q]) > 0) return turn > 0;
    return cross_sign(all[p], wall) < 0;
  });
}

TangentParts::TangentParts(const FreeSpace& space, double radius) : r(radius), walls(space, radius) {
  find_sites();
  find_legs();
  build_rings();
  sort_legs();
}

void TangentParts::find_sites() {
  const WallIndex& gate_walls = walls.walls();
  const Triangulation& tri = gate_walls.triangulation();
  site_at.assign(tri.points.size(), kNone);
  const auto add = [&](TangentSite site) {
    if (site_at[site.vertex] == kNone) site_at[site.vertex] = static_cast<std::uint32_t>(sites.size());
    sites.push_back(std::move(site));
  };
  for (std::uint32_t v = 0; v < tri.points.size(); ++v) {
    TangentSite site{tri.points[v], v, kNone, gate_walls.is_wall_vertex(v), {}};
    for (const std::uint32_t c : gate_walls.at(v))
      if (!gate_walls.is_opening(c))
        site.walls.push_back(tri.points[gate_walls.ends()[c][gate_walls.ends()[c][0] == v]]);
    if (site.round) {
      const auto hull = hull_of(site.at, site.walls);
      if (!hull || !is_free_beyond(gate_walls, v, *hull)) continue;
      site.cones = TautCones(site.at, (*hull)[0], (*hull)[1], r);
      add(std::move(site));
      continue;
    }
    for (const Triangulation::Sector& sector : tri.sectors_at(v))
      if (sector.reflex) {
        site.sector = static_cast<std::uint32_t>(&sector - tri.sectors.data());
        add(site);
      }
  }
}

void TangentParts::find_legs() {
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    for (const std::uint32_t v : walls.seen_from_vertex(sites[i].vertex, sites[i].cones)) {
      const std::uint32_t j = site_at[v];
      if (j == kNone || j <= i || sites[j].vertex == sites[i].vertex) continue;
      const Point back{sites[i].at.x - sites[j].at.x, sites[i].at.y - sites[j].at.y};
      if (!sites[j].cones.may_lead(back)) continue;
      for (const TangentPair& pair : free_tangents(walls, r, sites[i], sites[j])) {
        const auto from = static_cast<std::uint32_t>(points.size());
        const int s = pair.from.here.side, t = -pair.to.here.side;
        points.push_back(pair.from);
        points.push_back(pair.to);
        site_of.insert(site_of.end(), {i, j});
        legs.push_back({from, from + 1, s, t, pair.length});
        legs.push_back({from + 1, from, -t, -s, pair.length});
      }
    }
  }
}

void TangentParts::build_rings() {
  rings.resize(sites.size());
  for (std::uint32_t p = 0; p < points.size(); ++p) rings[site_of[p]].points.push_back(p);
  std::vector<std::uint32_t> same(points.size());
  std::iota(same.begin(), same.end(), 0u);
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    std::vector<std::uint32_t>& ring = rings[i].points;
    if (sites[i].round) sort_around(ring, points, sites[i]);
    std::size_t kept = 0;
    for (const std::uint32_t p : ring) {
      if (kept > 0 && (!sites[i].round || same_point(points[ring[kept - 1]], points[p])))
        same[p] = ring[kept - 1];
      else
        ring[kept++] = p;
    }
    ring.resize(kept);
    if (!sites[i].round || kept < 2) continue;
    const CircleObstacles obstacles = walls.around(sites[i].at);
    for (std::size_t k = 0; k + 1 < kept; ++k) {
      rings[i].free.push_back(walls.arc_is_free(points[ring[k]], points[ring[k + 1]], obstacles));
      arcs += rings[i].free.back();
    }
  }
  for (TangentLeg& leg : legs) {
    leg.from = same[leg.from];
    leg.to = same[leg.to];
  }
}

void TangentParts::sort_legs() {
  std::stable_sort(legs.begin(), legs.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
  first_leg.assign(points.size() + 1, 0);
  for (const TangentLeg& leg : legs) ++first_leg[leg.from + 1];
  std::partial_sum(first_leg.begin(), first_leg.end(), first_leg.begin());
}

TangentGraph::TangentGraph(const FreeSpace& space, double r) {
  TAUT_EXPECTS(space.footprint().kind() == Footprint::Kind::point);
  TAUT_EXPECTS(r > 0 && r <= World::kLargest);
  parts_ = std::make_shared<const TangentParts>(space, r);
}

const FreeSpace& TangentGraph::space() const { return parts_->walls.space(); }
double TangentGraph::radius() const { return parts_->r; }
std::size_t TangentGraph::corner_count() const { return parts_->sites.size(); }
std::size_t TangentGraph::leg_count() const { return parts_->legs.size() / 2; }
std::size_t TangentGraph::arc_count() const { return parts_->arcs; }
std::size_t TangentGraph::point_count() const {
  std::size_t count = 0;
  for (const TangentRing& ring : parts_->rings) count += ring.points.size();
  return count;
}

}  // namespace taut
