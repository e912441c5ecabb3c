#include <taut/geometry/detail/ray_walk.h>

#include <taut/geometry/predicates.h>

namespace taut::detail {

using Tri = Triangulation;

int RayWalk::side(Point x) const { return orientation(p_, q_, x); }

bool RayWalk::ahead(Point from, Point x) const {
  if (p_.x != q_.x) return (q_.x > p_.x) == (x.x > from.x) && x.x != from.x;
  return (q_.y > p_.y) == (x.y > from.y) && x.y != from.y;
}

bool RayWalk::ends_by(Point x) const { return bounded_ && !ahead(x, q_); }

RayWalk::End RayWalk::start(const Location& at) {
  switch (at.kind) {
    case Location::Kind::outside: return End::blocked;
    case Location::Kind::vertex: {
      const std::uint32_t v = tri_.triangles[at.triangle][at.index];
      const auto here = tri_.sectors_at(v);
      // All sectors are open to a path that starts here; the direction lies in one, or along the side between two.
      Stand found;
      End end = End::blocked;
      for (const auto& sector : here) {
        Stand next;
        const auto result = leave_sector(static_cast<std::uint32_t>(&sector - tri_.sectors.data()), next);
        if (!result) continue;
        if (*result != End::vertex) {
          if (*result == End::reached) return End::reached;
          continue;
        }
        end = End::vertex;
        if (found.vertex == kNone) found = next;
        else found.sectors[1] = next.sectors[0];
      }
      stand_ = found;
      return end;
    }
    case Location::Kind::side: return along_side(at.triangle, at.index);
    case Location::Kind::triangle: return in_triangle(at.triangle);
  }
  return End::blocked;
}

/// From p in the closed triangle t.
RayWalk::End RayWalk::in_triangle(std::uint32_t t) {
  if (bounded_) {
    bool inside = true;
    for (int i = 0; i < 3; ++i) inside = inside && orientation(corner(t, i), corner(t, Tri::ccw(i)), q_) >= 0;
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
RayWalk::End RayWalk::along_side(std::uint32_t t, int i) {
  const std::uint32_t n = tri_.neighbours[t][i];
  const bool both = n != kNone && tri_.free[n];
  const Point a = corner(t, Tri::ccw(i)), b = corner(t, Tri::cw(i));
  const int turn = orientation(a, b, q_);
  if (turn > 0) return in_triangle(t);
  if (turn < 0) return both ? in_triangle(n) : End::blocked;
  const int forward = ahead(p_, b) ? Tri::cw(i) : Tri::ccw(i);
  const End end = arrive(t, forward);
  if (end == End::vertex && both) stand_.sectors[1] = tri_.sector_of[3 * n + tri_.corner(n, stand_.vertex)];
  return end;
}

/// Out of triangle t by side i, and on.
RayWalk::End RayWalk::through(std::uint32_t t, int i) {
  for (;;) {
    if (bounded_ && orientation(corner(t, Tri::ccw(i)), corner(t, Tri::cw(i)), q_) >= 0) return End::reached;
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

/// Leaves the vertex of a sector within it; nothing when the ray does not start there.
std::optional<RayWalk::End> RayWalk::leave_sector(std::uint32_t id, Stand& next) {
  const Tri::Sector& sector = tri_.sectors[id];
  const Point v = tri_.points[sector.vertex];
  std::uint32_t t = sector.triangle;
  for (;;) {
    const int i = tri_.corner(t, sector.vertex), right = Tri::ccw(i), left = Tri::cw(i);
    const int r = side(corner(t, right)), l = side(corner(t, left));
    for (const auto& [turn, c] : {std::pair(r, right), std::pair(l, left)}) {
      if (turn != 0 || !ahead(v, corner(t, c))) continue;
      const End end = arrive(t, c);
      next = stand_;
      return end;
    }
    if (r < 0 && l > 0) {
      const End end = through(t, i);
      next = stand_;
      return end;
    }
    if (tri_.is_constrained(t, right)) return std::nullopt;
    t = tri_.ccw_triangle(t, i);
    if (t == kNone || t == sector.triangle) return std::nullopt;
  }
}

RayWalk::End RayWalk::next() {
  const Stand from = stand_;
  Stand found;
  for (const std::uint32_t sector : from.sectors) {
    if (sector == kNone) continue;
    Stand reached;
    const auto end = leave_sector(sector, reached);
    if (!end || *end == End::blocked) continue;
    if (*end == End::reached) return End::reached;
    if (found.vertex == kNone) found = reached;
    else if (found.sectors[0] != reached.sectors[0]) found.sectors[1] = reached.sectors[0];
  }
  stand_ = found;
  return found.vertex == kNone ? End::blocked : End::vertex;
}

}  // namespace taut::detail
