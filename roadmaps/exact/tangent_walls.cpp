#include <taut/roadmaps/exact/tangent_walls.h>

#include <algorithm>

#include <taut/geometry/segment_distance.h>
#include <taut/geometry/triangular_expansion.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

using Tri = Triangulation;

Triangulation without_openings(const WallIndex& walls) {
  Triangulation tri = walls.triangulation();
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (const std::uint32_t c = walls.along(t, i); c != kNone && walls.is_opening(c) && tri.neighbours[t][i] != kNone)
        tri.constrained[t] = static_cast<std::uint8_t>(tri.constrained[t] & ~(1 << i));
  return tri;
}

/// Collects what an expansion sees, as far as legs may lead there.
struct Seen {
  const Triangulation& tri;
  Point origin;
  const TautCones& cones;
  std::vector<std::uint32_t> vertices;

  Point to(std::uint32_t v) const { return {tri.points[v].x - origin.x, tri.points[v].y - origin.y}; }

  static bool hides(std::uint32_t) { return false; }
  void vertex(std::uint32_t t, int k) { add(tri.triangles[t][k]); }
  void add(std::uint32_t v) {
    if (cones.may_lead(to(v))) vertices.push_back(v);
  }
  template <class Ray>
  static void blocked(std::uint32_t, int, const Ray&, const Ray&) {}
  template <class Ray>
  bool skips(std::uint32_t t, int i, const Ray& right, const Ray& left) const {
    return cones.is_bounded() && !cones.may_lead(to(right.vertex), to(left.vertex), distance_to_side(t, i));
  }

 private:
  /// No more than that of the side from the origin.
  double distance_to_side(std::uint32_t t, int i) const {
    const Point p = to(tri.triangles[t][Tri::ccw(i)]), q = to(tri.triangles[t][Tri::cw(i)]);
    const Point d{q.x - p.x, q.y - p.y};
    const double at_p = -(d.x * p.x + d.y * p.y), at_q = d.x * q.x + d.y * q.y;
    const double ends = std::min(std::hypot(p.x, p.y), std::hypot(q.x, q.y));
    if (at_p <= 0 || at_q <= 0) return ends * (1 - 1e-9);
    return std::min(ends, std::abs(p.x * q.y - p.y * q.x) / std::hypot(d.x, d.y)) * (1 - 1e-6);
  }
};

/// Is a direction, given by its turn from each bound of a sector (the sign of bound x direction), in the closed sector?
/// A path that bends to the left (bend = 1) leaves a left bound that it is parallel to, and so on.
template <class Turn, class Along>
bool in_sector(const Triangulation& tri, const Tri::Sector& sector, int bend, Turn turn, Along is_along) {
  if (sector.full) return true;
  const Point v = tri.points[sector.vertex], right = tri.points[sector.right], left = tri.points[sector.left];
  const int from_right = turn(right), from_left = turn(left);
  if (from_right == 0 && is_along(right)) return bend >= 0;
  if (from_left == 0 && is_along(left)) return bend <= 0;
  if (sector.right == sector.left) return true;
  const int wide = written::orientation(v, right, left);
  if (wide > 0) return from_right > 0 && from_left < 0;
  if (wide < 0) return !(from_left > 0 && from_right < 0);
  return from_right > 0;
}

bool is_nearer(Point p, const Segment& s, double r) {
  const Rational fx = meaning(s.b.x) - meaning(s.a.x), fy = meaning(s.b.y) - meaning(s.a.y),
                 r2 = meaning(r) * meaning(r);
  const Rational x = meaning(p.x) - meaning(s.a.x), y = meaning(p.y) - meaning(s.a.y), F = fx * fx + fy * fy;
  const Rational along = x * fx + y * fy, off = fx * y - fy * x;
  if (along <= 0) return x * x + y * y < r2;
  if (along < F) return off * off < r2 * F;
  return (x - fx) * (x - fx) + (y - fy) * (y - fy) < r2;
}

int sign_of(const Rational& v) { return sgn(v); }

}  // namespace

TangentWalls::TangentWalls(const FreeSpace& space)
    : walls_(space), open_(without_openings(walls_)), opening_boxes_([&] {
        std::vector<Box> boxes;
        for (std::uint32_t c = 0; c < walls_.ends().size(); ++c) {
          if (!walls_.is_opening(c)) continue;
          openings_.push_back(c);
          boxes.push_back(box_around(walls_.segment(c).a, walls_.segment(c).b));
        }
        return boxes;
      }()) {}

bool TangentWalls::is_free(const TangentLine& line, std::uint32_t from_sector, std::uint32_t to_sector) const {
  bool free = true;
  // The box of a long slanted leg holds far more than what lies along it.
  const int pieces = line.pieces();
  for (int i = 0; i < pieces && free; ++i)
    walls_.walls_meeting(line.box(double(i) / pieces, double(i + 1) / pieces), [&](std::uint32_t c) {
      if (free) free = line.clears(walls_.segment(c).a, walls_.segment(c).b);
    });
  if (!free || openings_.empty()) return free;
  opening_boxes_.meeting(line.box(0, 1), [&](std::uint32_t i) {
    if (!free) return;
    const std::uint32_t c = openings_[i];
    const Segment s = walls_.segment(c);
    free = !line.leaves_by(s.a, s.b, space().constraints()[c].solid_left);
    for (const std::uint32_t v : walls_.ends()[c])
      if (free && !walls_.is_wall_vertex(v)) free = passes_vertex(line, v, from_sector, to_sector);
  });
  return free;
}

bool TangentWalls::passes_vertex(const TangentLine& line, std::uint32_t v, std::uint32_t from_sector,
                                 std::uint32_t to_sector) const {
  const Triangulation& tri = walls_.triangulation();
  const Point at = tri.points[v];
  if (line.off(at) != 0) return true;
  const int before = line.along(at), after = line.left_over(at);
  if (before < 0 || after < 0) return true;
  const std::span<const Tri::Sector> sectors = tri.sectors_at(v);
  return std::any_of(sectors.begin(), sectors.end(), [&](const Tri::Sector& sector) {
    const auto id = static_cast<std::uint32_t>(&sector - tri.sectors.data());
    if (before == 0 && from_sector != kNone && from_sector != id) return false;
    if (after == 0 && to_sector != kNone && to_sector != id) return false;
    const auto holds = [&](int way) {
      return in_sector(
          tri, sector, 0, [&](Point bound) { return way * line.turn(at, bound); },
          [&](Point bound) { return way * line.onward(at, bound) > 0; });
    };
    return (before == 0 || holds(-1)) && (after == 0 || holds(1));
  });
}

CircleObstacles TangentWalls::around(Point centre, double r) const {
  CircleObstacles result;
  const double more = 1e-12 * (std::abs(centre.x) + std::abs(centre.y));
  const double reach = 2.001 * r + more;
  const Box box{{centre.x - reach, centre.y - reach}, {centre.x + reach, centre.y + reach}};
  walls_.walls_meeting(box, [&](std::uint32_t c) {
    const Segment s = walls_.segment(c);
    if (s.a == centre || s.b == centre) return;
    if (const auto direction = direction_forbidden(centre, r, s.a, s.b)) result.forbidden.push_back(*direction);
  });
  add_crossings(centre, r, result);
  return result;
}

void TangentWalls::add_crossings(Point centre, double r, CircleObstacles& result) const {
  if (openings_.empty()) return;
  const Rational r2 = meaning(r) * meaning(r);
  const double reach = 1.001 * r + 1e-12 * (std::abs(centre.x) + std::abs(centre.y));
  opening_boxes_.meeting(
      {{centre.x - reach, centre.y - reach}, {centre.x + reach, centre.y + reach}}, [&](std::uint32_t i) {
        const std::uint32_t c = openings_[i];
        const Segment s = walls_.segment(c);
        const Rational fx = meaning(s.b.x) - meaning(s.a.x), fy = meaning(s.b.y) - meaning(s.a.y);
        const Rational x = meaning(s.a.x) - meaning(centre.x), y = meaning(s.a.y) - meaning(centre.y);
        for (const std::uint32_t v : walls_.ends()[c]) {
          const Point p = walls_.triangulation().points[v];
          const Rational px = meaning(p.x) - meaning(centre.x), py = meaning(p.y) - meaning(centre.y);
          if (!walls_.is_wall_vertex(v) && px * px + py * py == r2)
            result.crossings.push_back({{px, py, 0, 0, 0}, kNone, v});
        }
        // The points a + t f with |a + t f|^2 = r^2.
        const Rational F = fx * fx + fy * fy, half = (x * fx + y * fy) / F;
        const Rational R = half * half - (x * x + y * y - r2) / F;
        if (sgn(R) <= 0) return;
        for (const int way : {-1, 1}) {
          const Rational t = -half, rest = 1 - t, w = way;
          if (surd_sign(t, w, R) <= 0 || surd_sign(rest, Rational(-way), R) <= 0) continue;
          result.crossings.push_back({{x + t * fx, y + t * fy, w * fx, w * fy, R}, c, kNone});
        }
      });
}

bool TangentWalls::arc_is_free(const TangentPoint& a, const TangentPoint& b, const CircleObstacles& obstacles) const {
  for (const PlainDirection& v : obstacles.forbidden)
    if (cross_sign(a, v) > 0 && cross_sign(b, v) < 0) return false;
  for (const CircleObstacles::Crossing& crossing : obstacles.crossings) {
    const auto same = [&](const TangentPoint& p) {
      if (cross_sign(p, crossing.at) != 0) return false;
      const SurdDirection e = p.exact();
      const Surd<Rational> P{e.ax * crossing.at.ax + e.ay * crossing.at.ay,
                             e.bx * crossing.at.ax + e.by * crossing.at.ay};
      const Surd<Rational> Q{e.ax * crossing.at.bx + e.ay * crossing.at.by,
                             e.bx * crossing.at.bx + e.by * crossing.at.by};
      return surd_sign(P, Q, e.R, crossing.at.R) > 0;
    };
    const bool at_a = same(a), at_b = same(b);
    if (!at_a && !at_b && !(cross_sign(a, crossing.at) > 0 && cross_sign(b, crossing.at) < 0)) continue;
    if (crossing.vertex != kNone) {
      if (!arc_passes_vertex(a.here.centre, crossing.vertex, !at_a, !at_b)) return false;
      continue;
    }
    if (!at_a && !at_b) return false;
    const Segment s = walls_.segment(crossing.opening);
    const Rational fx = meaning(s.b.x) - meaning(s.a.x), fy = meaning(s.b.y) - meaning(s.a.y);
    const Rational plain = fx * crossing.at.ax + fy * crossing.at.ay,
                   rooted = fx * crossing.at.bx + fy * crossing.at.by;
    const int to_left = surd_sign(plain, rooted, crossing.at.R);  // going counter-clockwise
    const int solid = space().constraints()[crossing.opening].solid_left ? 1 : -1;
    if (at_a ? to_left == solid : to_left == -solid) return false;
  }
  return true;
}

bool TangentWalls::arc_passes_vertex(Point centre, std::uint32_t v, bool before, bool after) const {
  const Triangulation& tri = walls_.triangulation();
  const Point at = tri.points[v];
  const Rational ux = meaning(centre.y) - meaning(at.y),
                 uy = meaning(at.x) - meaning(centre.x);  // the way counter-clockwise
  const std::span<const Tri::Sector> sectors = tri.sectors_at(v);
  return std::any_of(sectors.begin(), sectors.end(), [&](const Tri::Sector& sector) {
    const auto holds = [&](int way) {
      const auto part = [&](Point bound, bool crossed) {
        const Rational fx = meaning(bound.x) - meaning(at.x), fy = meaning(bound.y) - meaning(at.y);
        const Rational value = crossed ? Rational(fx * uy - fy * ux) : Rational(fx * ux + fy * uy);
        return way * sign_of(value);
      };
      return in_sector(
          tri, sector, way, [&](Point bound) { return part(bound, true); },
          [&](Point bound) { return part(bound, false) > 0; });
    };
    return (!before || holds(-1)) && (!after || holds(1));
  });
}

template <class Coordinates>
std::vector<std::uint32_t> TangentWalls::seen(const std::vector<std::array<std::uint32_t, 2>>& views,
                                              typename Coordinates::Place origin, Point at,
                                              const TautCones& cones) const {
  Seen seen{open_, at, cones, {}};
  Expansion<Coordinates, Seen> expansion(open_, seen);
  for (const auto& [t, side] : views) {
    const int i = static_cast<int>(side);
    const std::uint32_t right = open_.triangles[t][Tri::ccw(i)], left = open_.triangles[t][Tri::cw(i)];
    seen.add(right);
    seen.add(left);
    expansion.spread(origin, t, i, expansion.ray(right), expansion.ray(left));
  }
  std::sort(seen.vertices.begin(), seen.vertices.end());
  seen.vertices.erase(std::unique(seen.vertices.begin(), seen.vertices.end()), seen.vertices.end());
  return std::move(seen.vertices);
}

std::vector<std::uint32_t> TangentWalls::seen_from_vertex(std::uint32_t v, const TautCones& cones) const {
  std::vector<std::array<std::uint32_t, 2>> views;
  for (const std::uint32_t t : walls_.around(v)) views.push_back({t, static_cast<std::uint32_t>(open_.corner(t, v))});
  if (open_.lattice.empty()) return seen<DoubleCoordinates>(views, open_.points[v], open_.points[v], cones);
  return seen<LatticeCoordinates>(views, open_.lattice[v], open_.points[v], cones);
}

std::vector<std::uint32_t> TangentWalls::seen_from(Point p) const {
  const Location at = space().locate(p);
  if (at.kind == Location::Kind::outside) return {};
  if (at.kind == Location::Kind::vertex) return seen_from_vertex(open_.triangles[at.triangle][at.index]);
  std::vector<std::array<std::uint32_t, 2>> views;
  const auto add = [&](std::uint32_t t, int except) {
    for (int i = 0; i < 3; ++i)
      if (i != except) views.push_back({t, static_cast<std::uint32_t>(i)});
  };
  const bool on_side = at.kind == Location::Kind::side;
  add(at.triangle, on_side ? at.index : 3);
  if (on_side && !open_.is_constrained(at.triangle, at.index))
    add(open_.neighbours[at.triangle][at.index], open_.mirror(at.triangle, at.index));
  return seen<DoubleCoordinates>(views, p, p, {});
}

std::uint32_t TangentWalls::too_near(Point p, double r) const {
  std::uint32_t nearest = kNone;
  const double reach = 1.001 * r + 1e-12 * (std::abs(p.x) + std::abs(p.y));
  const Segment here{p, p};
  const auto segment = [&](std::uint32_t c) { return walls_.segment(c); };
  walls_.walls_meeting({{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}}, [&](std::uint32_t c) {
    const Interval distance = segment_distance_interval(here, segment(c));
    if (distance.lo > r || (distance.hi >= r && !is_nearer(p, segment(c), r))) return;
    const int order = nearest == kNone ? -1 : compare_segment_distances(here, segment(c), here, segment(nearest));
    if (order < 0 || (order == 0 && c < nearest)) nearest = c;
  });
  return nearest;
}

}  // namespace taut
