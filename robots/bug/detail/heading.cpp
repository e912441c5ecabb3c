#include <taut/robots/bug/detail/heading.h>

#include <algorithm>

#include <taut/geometry/predicates.h>

namespace taut::bug::detail {

namespace {

using Tri = Triangulation;

int sign(double v) { return (v > 0) - (v < 0); }

/// Are a and b on the same ray out of v? Precondition: all three are in line, neither is v.
bool same_way(Point v, Point a, Point b) {
  return sign(a.x - v.x) == sign(b.x - v.x) && sign(a.y - v.y) == sign(b.y - v.y);
}

bool runs_along(Point v, Point far, Point goal) { return orientation(v, far, goal) == 0 && same_way(v, far, goal); }

std::optional<Point> as_doubles(const ExactPoint& p) {
  const Point q{p.x.get_d(), p.y.get_d()};
  return ExactPoint(q) == p ? std::optional(q) : std::nullopt;
}

/// One step after the other: at a vertex, or inside a triangle that was entered by a side.
class Walker {
 public:
  Walker(const Tri& tri, const ExactPoint& from, Point goal)
      : tri_(tri), exact_(from), from_(as_doubles(from)), goal_(goal), walk_() {}

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

  int side(Point v) const {
    if (from_) return orientation(*from_, goal_, v);
    return sgn((goal_.x - exact_.x) * (v.y - exact_.y) - (goal_.y - exact_.y) * (v.x - exact_.x));
  }

  bool holds_goal(std::uint32_t t) const {
    for (int i = 0; i < 3; ++i)
      if (orientation(corner(t, i), corner(t, Tri::ccw(i)), goal_) < 0) return false;
    return true;
  }

  void enter(std::uint32_t t) { walk_.pieces.back().triangles.push_back(t); }

  void finish() {
    walk_.reached = true;
    done_ = true;
  }

  void hit(Stand stand) {
    walk_.end = std::move(stand);
    done_ = true;
  }

  void from_open(std::uint32_t t) {
    enter(t);
    if (holds_goal(t)) return finish();
    for (int i = 0; i < 3; ++i) {
      const Point a = corner(t, Tri::ccw(i)), b = corner(t, Tri::cw(i));
      if (orientation(a, b, *from_) != 0) continue;
      const int o = orientation(a, b, goal_);
      if (o > 0) return through(t, i);
      if (o == 0) return arrive(t, runs_along(*from_, a, goal_) ? Tri::ccw(i) : Tri::cw(i));
      return leave(t, i);
    }
    for (int i = 0; i < 3; ++i) {
      const Point a = corner(t, Tri::ccw(i)), b = corner(t, Tri::cw(i));
      const int right = side(a), left = side(b);
      if (right == 0 && same_way(*from_, a, goal_)) return arrive(t, Tri::ccw(i));
      if (right < 0 && left > 0) return leave(t, i);
    }
  }

  void from_side(const Stand& stand) {
    const Point tail = corner(stand.t, Tri::ccw(stand.i)), head = corner(stand.t, Tri::cw(stand.i));
    const int o = orientation(tail, head, goal_);
    if (o < 0) return hit(stand);
    enter(stand.t);
    if (holds_goal(stand.t)) return finish();
    if (o > 0) return through(stand.t, stand.i);
    arrive(stand.t, same_way(tail, head, goal_) && goal_ != tail ? Tri::cw(stand.i) : Tri::ccw(stand.i));
  }

  /// Inside t, entered by side i.
  void inside(std::uint32_t t, int i) {
    enter(t);
    if (holds_goal(t)) return finish();
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
      return hit({Stand::Kind::side, t, i, kNone, crossing(corner(t, Tri::ccw(i)), corner(t, Tri::cw(i)))});
    next_ = {false, kNone, tri_.neighbours[t][i], tri_.mirror(t, i)};
  }

  void arrive(std::uint32_t t, int i) {
    walk_.pieces.back().to = corner(t, i);
    if (corner(t, i) == goal_) return finish();
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
    if (holds_goal(way->t)) return finish();
    if (orientation(v, corner(way->t, Tri::ccw(way->i)), goal_) == 0) return arrive(way->t, Tri::ccw(way->i));
    if (orientation(v, corner(way->t, Tri::cw(way->i)), goal_) == 0) return arrive(way->t, Tri::cw(way->i));
    leave(way->t, way->i);
  }

  ExactPoint crossing(Point a, Point b) const {
    if (from_) return taut::detail::line_crossing({*from_, goal_}, {a, b});
    const ExactPoint p(a), q(b);
    const mpq_class dx = goal_.x - exact_.x, dy = goal_.y - exact_.y, ex = q.x - p.x, ey = q.y - p.y;
    const mpq_class along = ((p.x - exact_.x) * ey - (p.y - exact_.y) * ex) / (dx * ey - dy * ex);
    return {exact_.x + along * dx, exact_.y + along * dy};
  }

  const Tri& tri_;
  const ExactPoint& exact_;
  std::optional<Point> from_;
  Point goal_;
  Walk walk_;
  Next next_;
  bool done_ = false;
};

}  // namespace

bool is_open(const Triangulation& tri, const Stand& stand, Point goal) {
  if (stand.kind == Stand::Kind::open) return true;
  if (stand.kind == Stand::Kind::vertex) return tri.looks_to(tri.sectors[stand.sector], goal);
  const auto& corners = tri.triangles[stand.t];
  return orientation(tri.points[corners[Tri::ccw(stand.i)]], tri.points[corners[Tri::cw(stand.i)]], goal) >= 0;
}

bool leads_off(const Triangulation& tri, const Stand& stand, Point goal) {
  if (!is_open(tri, stand, goal)) return false;
  if (stand.kind == Stand::Kind::open) return true;
  if (stand.kind == Stand::Kind::vertex) {
    const Tri::Sector& sector = tri.sectors[stand.sector];
    const Point v = tri.points[sector.vertex];
    return sector.full ||
           (!runs_along(v, tri.points[sector.right], goal) && !runs_along(v, tri.points[sector.left], goal));
  }
  const auto& corners = tri.triangles[stand.t];
  return orientation(tri.points[corners[Tri::ccw(stand.i)]], tri.points[corners[Tri::cw(stand.i)]], goal) > 0;
}

Walk walk_to(const Triangulation& tri, const Stand& stand, const ExactPoint& from, Point goal) {
  return Walker(tri, from, goal).go(stand);
}

}  // namespace taut::bug::detail
