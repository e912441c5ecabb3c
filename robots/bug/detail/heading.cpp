#include <taut/robots/bug/detail/heading.h>

#include <taut/geometry/written.h>

namespace taut::bug::detail {

namespace {

using Tri = Triangulation;

bool runs_along(Point v, Point far, const Spot& goal) {
  return orientation(v, far, goal) == 0 && same_way(ExactPoint(v), ExactPoint(far), goal.exact);
}

/// One step after the other: at a vertex, or inside a triangle that was entered by a side.
class Walker {
 public:
  Walker(const Tri& tri, const ExactPoint& from, const Spot& goal) : tri_(tri), from_(from), goal_(goal), walk_() {}

  Walk go(const Stand& stand) {
    walk_.pieces.emplace_back();
    switch (stand.kind) {
      case Stand::Kind::open: from_open(stand.t); break;
      case Stand::Kind::side: from_side(stand); break;
      case Stand::Kind::vertex: at_vertex(stand.sector); break;
    }
    while (!done_) next_.corner ? at_vertex(next_.sector) : inside(next_.t, next_.i);
    return std::move(walk_);
  }

 private:
  struct Next {
    bool corner = false;
    std::uint32_t sector = kNone;
    std::uint32_t t = kNone;
    int i = 0;
  };

  Point corner(std::uint32_t t, int i) const { return tri_.points[tri_.triangles[t][i]]; }

  int side(Point v) const { return orientation(from_, goal_, v); }
  bool is_goal(Point v) const { return goal_.doubles == v; }

  bool holds_goal(std::uint32_t t) const {
    for (int i = 0; i < 3; ++i)
      if (orientation(corner(t, i), corner(t, Tri::ccw(i)), goal_) < 0) return false;
    return true;
  }

  void enter(std::uint32_t t) { walk_.pieces.back().triangles.push_back(t); }

  /// The goal is in the closed triangle t.
  void finish(std::uint32_t t) {
    walk_.reached = true;
    hit({Stand::Kind::open, t, 0, kNone, goal_.exact});
    for (int i = 0; i < 3; ++i) {
      if (is_goal(corner(t, i)))
        return hit({Stand::Kind::vertex, t, 0, tri_.sector_of[3 * t + static_cast<std::uint32_t>(i)], goal_.exact});
      if (tri_.is_constrained(t, i) && orientation(corner(t, Tri::ccw(i)), corner(t, Tri::cw(i)), goal_) == 0)
        walk_.end = {Stand::Kind::side, t, i, kNone, goal_.exact};
    }
  }

  void hit(Stand stand) {
    walk_.end = std::move(stand);
    done_ = true;
  }

  void from_open(std::uint32_t t) {
    enter(t);
    if (holds_goal(t)) return finish(t);
    for (int i = 0; i < 3; ++i) {
      const Point a = corner(t, Tri::ccw(i)), b = corner(t, Tri::cw(i));
      if (orientation(a, b, from_) != 0) continue;
      const int o = orientation(a, b, goal_);
      if (o > 0) return through(t, i);
      if (o == 0) return arrive(t, same_way(from_.exact, ExactPoint(a), goal_.exact) ? Tri::ccw(i) : Tri::cw(i));
      return leave(t, i);
    }
    for (int i = 0; i < 3; ++i) {
      const Point a = corner(t, Tri::ccw(i)), b = corner(t, Tri::cw(i));
      const int right = side(a), left = side(b);
      if (right == 0 && same_way(from_.exact, ExactPoint(a), goal_.exact)) return arrive(t, Tri::ccw(i));
      if (right < 0 && left > 0) return leave(t, i);
    }
  }

  void from_side(const Stand& stand) {
    const Point tail = corner(stand.t, Tri::ccw(stand.i)), head = corner(stand.t, Tri::cw(stand.i));
    const int o = orientation(tail, head, goal_);
    if (o < 0) return hit(stand);
    enter(stand.t);
    if (holds_goal(stand.t)) return finish(stand.t);
    if (o > 0) return through(stand.t, stand.i);
    arrive(stand.t, same_way(stand.at, ExactPoint(head), goal_.exact) ? Tri::cw(stand.i) : Tri::ccw(stand.i));
  }

  /// Inside t, entered by side i.
  void inside(std::uint32_t t, int i) {
    enter(t);
    if (holds_goal(t)) return finish(t);
    through(t, i);
  }

  void through(std::uint32_t t, int i) {
    const int o = side(corner(t, i));
    if (o == 0) return arrive(t, i);
    leave(t, o > 0 ? Tri::ccw(i) : Tri::cw(i));
  }

  /// Out of t by a point inside its side i.
  void leave(std::uint32_t t, int i) {
    if (tri_.is_constrained(t, i))
      return hit(
          {Stand::Kind::side, t, i, kNone, crossing(from_, goal_, corner(t, Tri::ccw(i)), corner(t, Tri::cw(i)))});
    next_ = {false, kNone, tri_.neighbours[t][i], tri_.mirror(t, i)};
  }

  void arrive(std::uint32_t t, int i) {
    walk_.pieces.back().to = corner(t, i);
    if (is_goal(corner(t, i))) return finish(t);
    walk_.pieces.emplace_back();
    next_ = {true, tri_.sector_of[3 * t + static_cast<std::uint32_t>(i)], kNone, 0};
  }

  void at_vertex(std::uint32_t sector) {
    const Tri::Sector& s = tri_.sectors[sector];
    const Point v = tri_.points[s.vertex];
    std::optional<Next> way;
    each_triangle(tri_, s, [&](std::uint32_t t, int i) {
      if (!way && orientation(v, corner(t, Tri::ccw(i)), goal_) >= 0 &&
          orientation(v, corner(t, Tri::cw(i)), goal_) <= 0)
        way = Next{false, kNone, t, i};
    });
    if (!way) return hit({Stand::Kind::vertex, s.triangle, 0, sector, ExactPoint(v)});
    enter(way->t);
    if (holds_goal(way->t)) return finish(way->t);
    if (orientation(v, corner(way->t, Tri::ccw(way->i)), goal_) == 0) return arrive(way->t, Tri::ccw(way->i));
    if (orientation(v, corner(way->t, Tri::cw(way->i)), goal_) == 0) return arrive(way->t, Tri::cw(way->i));
    leave(way->t, way->i);
  }

  const Tri& tri_;
  const Spot from_;
  const Spot goal_;
  Walk walk_;
  Next next_;
  bool done_ = false;
};

}  // namespace

bool is_open(const Triangulation& tri, const Stand& stand, Point goal) {
  if (stand.kind == Stand::Kind::open) return true;
  if (stand.kind == Stand::Kind::vertex) return tri.looks_to(tri.sectors[stand.sector], goal);
  const auto& corners = tri.triangles[stand.t];
  return written::orientation(tri.points[corners[Tri::ccw(stand.i)]], tri.points[corners[Tri::cw(stand.i)]], goal) >= 0;
}

bool leads_off(const Triangulation& tri, const Stand& stand, Point goal) {
  if (!is_open(tri, stand, goal)) return false;
  if (stand.kind == Stand::Kind::open) return true;
  if (stand.kind == Stand::Kind::vertex) {
    const Tri::Sector& sector = tri.sectors[stand.sector];
    const Point v = tri.points[sector.vertex];
    return sector.full || (!runs_along(v, tri.points[sector.right], Spot(goal)) &&
                           !runs_along(v, tri.points[sector.left], Spot(goal)));
  }
  const auto& corners = tri.triangles[stand.t];
  return written::orientation(tri.points[corners[Tri::ccw(stand.i)]], tri.points[corners[Tri::cw(stand.i)]], goal) > 0;
}

Walk walk_to(const Triangulation& tri, const Stand& stand, const ExactPoint& from, const Spot& goal) {
  return Walker(tri, from, goal).go(stand);
}

}  // namespace taut::bug::detail
