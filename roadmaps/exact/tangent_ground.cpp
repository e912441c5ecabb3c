#include <taut/roadmaps/exact/tangent_parts.h>

#include <algorithm>
#include <array>
#include <optional>

#include <taut/geometry/written.h>
#include <taut/roadmaps/exact/plain_tangent.h>

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

bool is_free(const TangentWalls& walls, const TangentLine& line, const TangentSite& from, const TangentSite& to) {
  return line.exists() && clears_own_walls(line, from, false) && clears_own_walls(line, to, true) &&
         walls.is_free(line, from.sector, to.sector);
}

TangentPair pair_of(const TangentEnd& here, const TangentEnd& there, double r, const Interval& length) {
  return {TangentPoint(here, there, r), TangentPoint({there.centre, -there.side}, {here.centre, -here.side}, r),
          length};
}

}  // namespace

TangentGround::TangentGround(const FreeSpace& space) : walls(space) {
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
      site.cones = TautCones(site.at, (*hull)[0], (*hull)[1]);
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

bool is_free_tangent(const TangentGround& ground, const TangentName& name, double r) {
  const TangentSite &from = ground.sites[name.from], &to = ground.sites[name.to];
  const TangentLine line({from.at, name.from_side}, {to.at, name.to_side}, r);
  return is_free(ground.walls, line, from, to);
}

std::vector<TangentPair> free_tangents(const TangentWalls& walls, double r, const TangentSite& from,
                                       const TangentSite& to, bool filtered) {
  std::vector<TangentPair> result;
  static constexpr std::array kRound{1, -1};
  static constexpr std::array kPoint{0};
  const auto sides = [](const TangentSite& site) {
    return site.round ? std::span<const int>(kRound) : std::span<const int>(kPoint);
  };
  for (const int s : sides(from))
    for (const int t : sides(to)) {
      const TangentEnd here{from.at, s}, there{to.at, t};
      const std::optional<bool> known = filtered ? plainly_free(walls, r, from, s, to, t) : std::nullopt;
      if (known ? *known : is_free(walls, TangentLine(here, there, r), from, to))
        result.push_back(pair_of(here, there, r, root(TangentFrame<Interval>(here, there, r).R)));
    }
  return result;
}

FoundTangent found_tangent(const TangentGround& ground, const TangentName& name, double r) {
  const TangentEnd here{ground.sites[name.from].at, name.from_side}, there{ground.sites[name.to].at, name.to_side};
  return {name, pair_of(here, there, r, root(TangentFrame<Interval>(here, there, r).R))};
}

}  // namespace taut
