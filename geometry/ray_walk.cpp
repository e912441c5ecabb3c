#include <taut/geometry/ray_walk.h>

#include <taut/geometry/written.h>

namespace taut {

using Tri = Triangulation;

int RayWalk::side(Point x) const { return written::orientation(p_, q_, x); }

bool RayWalk::ahead(Point from, Point x) const {
  if (p_.x != q_.x) return (q_.x > p_.x) == (x.x > from.x) && x.x != from.x;
  return (q_.y > p_.y) == (x.y > from.y) && x.y != from.y;
}

bool RayWalk::ends_by(Point x) const { return bounded_ && !ahead(x, q_); }

RayWalk::End RayWalk::start(const Location& at, std::optional<Point> towards) {
  switch (at.kind) {
    case Location::Kind::outside: break;
    case Location::Kind::vertex: return from_vertex(tri_.triangles[at.triangle][at.index], towards);
    case Location::Kind::side: return from_side(at.triangle, at.index, towards);
    case Location::Kind::triangle: return in_triangle(at.triangle);
  }
  return End::blocked;
}

/// All sectors are open to a path that starts here; the direction lies in one, or along the side between two.
RayWalk::End RayWalk::from_vertex(std::uint32_t v, std::optional<Point> towards) {
  Stand found;
  for (const Tri::Sector& sector : tri_.sectors_at(v)) {
    Stand next;
    if (towards && !tri_.looks_to(sector, *towards)) continue;
    const auto end = leave_sector(static_cast<std::uint32_t>(&sector - tri_.sectors.data()), next);
    if (end == End::reached) return End::reached;
    if (end == End::vertex) join(found, next);
  }
  stand_ = found;
  return found.vertex == kNone ? End::blocked : End::vertex;
}

/// Two ways to one vertex.
void RayWalk::join(Stand& found, const Stand& next) {
  if (found.vertex == kNone) {
    found = next;
    return;
  }
  for (const std::uint32_t sector : next.sectors)
    if (sector != kNone && sector != found.sectors[0]) found.sectors[1] = sector;
}

/// From p in the closed triangle t.
RayWalk::End RayWalk::in_triangle(std::uint32_t t) {
  if (bounded_) {
    bool inside = true;
    for (int i = 0; i < 3; ++i) inside = inside && written::orientation(corner(t, i), corner(t, Tri::ccw(i)), q_) >= 0;
    if (inside) return End::reached;
  }
  int sides[3];
  for (int i = 0; i < 3; ++i) sides[i] = side(corner(t, i));
  for (int i = 0; i < 3; ++i)
    if (sides[i] == 0 && ahead(p_, corner(t, i))) return arrive(t, i);
  for (int i = 0; i < 3; ++i)
    if (sides[Tri::ccw(i)] < 0 && sides[Tri::cw(i)] > 0) return through(t, i);
  return End::blocked;
}

/// From p on a constrained side, which has a free triangle on one or both sides.
RayWalk::End RayWalk::from_side(std::uint32_t t, int i, std::optional<Point> towards) {
  const std::uint32_t n = tri_.neighbours[t][i];
  const Point a = corner(t, Tri::ccw(i)), b = corner(t, Tri::cw(i));
  const int wanted = towards ? written::orientation(a, b, *towards) : 0, turn = written::orientation(a, b, q_);
  const bool here = wanted >= 0, there = wanted <= 0 && n != kNone && tri_.free[n];
  if (turn > 0) return here ? in_triangle(t) : End::blocked;
  if (turn < 0) return there ? in_triangle(n) : End::blocked;
  if (!here && !there) return End::blocked;
  const End end = arrive(t, ahead(p_, b) ? Tri::cw(i) : Tri::ccw(i));
  if (end != End::vertex || !there) return end;
  const std::uint32_t beyond = tri_.sector_of[3 * n + tri_.corner(n, stand_.vertex)];
  if (here)
    stand_.sectors[1] = beyond;
  else
    stand_.sectors[0] = beyond;
  return end;
}

/// Out of triangle t by side i, and on.
RayWalk::End RayWalk::through(std::uint32_t t, int i) {
  for (;;) {
    if (bounded_ && written::orientation(corner(t, Tri::ccw(i)), corner(t, Tri::cw(i)), q_) >= 0) return End::reached;
    if (tri_.is_constrained(t, i)) return End::blocked;
    const std::uint32_t n = tri_.neighbours[t][i];
    if (n == kNone) return End::blocked;
    const int k = tri_.mirror(t, i), turn = side(corner(n, k));
    if (turn == 0) return arrive(n, k);
    t = n;
    i = turn > 0 ? Tri::ccw(k) : Tri::cw(k);
  }
}

RayWalk::End RayWalk::arrive(std::uint32_t t, int i) {
  if (ends_by(corner(t, i))) return End::reached;
  stand_ = {tri_.triangles[t][i], {tri_.sector_of[3 * t + i], kNone}};
  return End::vertex;
}

/// Leaves the vertex of a sector within it; nothing when the ray does not start there. Along the wall at whose free end
/// the sector lies it starts on both sides.
std::optional<RayWalk::End> RayWalk::leave_sector(std::uint32_t id, Stand& next) {
  const Tri::Sector& sector = tri_.sectors[id];
  std::optional<End> end;
  Stand found;
  const auto take = [&](End e) {
    if (end != End::reached) end = e;
    if (e == End::vertex) join(found, stand_);
  };
  each_triangle(tri_, sector, [&](std::uint32_t t, int i) {
    const int r = side(corner(t, Tri::ccw(i))), l = side(corner(t, Tri::cw(i)));
    const Point v = tri_.points[sector.vertex];
    if (r < 0 && l > 0) return take(through(t, i));
    if (r == 0 && ahead(v, corner(t, Tri::ccw(i)))) take(arrive(t, Tri::ccw(i)));
    if (l == 0 && ahead(v, corner(t, Tri::cw(i)))) take(arrive(t, Tri::cw(i)));
  });
  next = found;
  return end;
}

RayWalk::End RayWalk::next() {
  const Stand from = stand_;
  Stand found;
  for (const std::uint32_t sector : from.sectors) {
    if (sector == kNone) continue;
    Stand next;
    const auto end = leave_sector(sector, next);
    if (end == End::reached) return End::reached;
    if (end == End::vertex) join(found, next);
  }
  stand_ = found;
  return found.vertex == kNone ? End::blocked : End::vertex;
}

}  // namespace taut
