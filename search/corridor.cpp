#include <taut/search/corridor.h>

#include <algorithm>

#include <taut/geometry/written.h>

namespace taut {

namespace {

using Tri = Triangulation;

/// Follows a path from vertex to vertex of the triangulation and remembers the triangles. At a vertex, or on a wall, it
/// may be in several places at once, one on each side of a wall: each is a state, and each state knows the cheapest one
/// that it comes from.
class CorridorWalk {
 public:
  explicit CorridorWalk(const FreeSpace& space) : space_(space), tri_(space.triangulation()) {}

  std::optional<Corridor> run(std::span<const Point> points) {
    if (points.empty() || !begin(points.front())) return std::nullopt;
    Point at = points.front();
    for (const Point to : points.subspan(1))
      if (to != at && !follow(at, to))
        return std::nullopt;
      else
        at = to;
    return Corridor{points.front(), at, triangles()};
  }

 private:
  struct State {
    std::uint32_t triangle;     // holds the current point
    std::uint32_t parent;       // the state at the point before; kNone at the start
    std::uint32_t loose;        // bends so far that are not taut
    std::uint32_t first, last;  // in passed_: the triangles from that of the parent, which is left out, to this one
  };

  Point corner(std::uint32_t t, int i) const { return tri_.points[tri_.triangles[t][i]]; }
  int side(Point x) const { return written::orientation(at_, to_, x); }

  /// x, on the line, lies ahead of the current point.
  bool is_ahead(Point x) const {
    if (at_.x != to_.x) return (to_.x > at_.x) == (x.x > at_.x) && x.x != at_.x;
    return (to_.y > at_.y) == (x.y > at_.y) && x.y != at_.y;
  }

  bool holds(std::uint32_t t, Point p) const {
    for (int i = 0; i < 3; ++i)
      if (written::orientation(corner(t, i), corner(t, Tri::ccw(i)), p) < 0) return false;
    return true;
  }

  /// Everywhere that a path can be that starts at p.
  bool begin(Point p) {
    const Location at = space_.locate(p);
    if (at.kind == Location::Kind::outside) return false;
    if (at.kind == Location::Kind::vertex) {
      for (const Tri::Sector& s : tri_.sectors_at(tri_.triangles[at.triangle][at.index])) start_in(s.triangle);
      return true;
    }
    start_in(at.triangle);
    if (at.kind == Location::Kind::side)
      if (const std::uint32_t n = tri_.neighbours[at.triangle][at.index]; n != kNone && tri_.free[n]) start_in(n);
    return true;
  }

  void start_in(std::uint32_t t) {
    const auto end = static_cast<std::uint32_t>(passed_.size());
    passed_.push_back(t);
    now_.push_back(static_cast<std::uint32_t>(states_.size()));
    states_.push_back({t, kNone, 0, end, end + 1});
  }

  /// One leg. All states come to the same vertices on it, since these are the vertices on a line.
  bool follow(Point from, Point to) {
    at_ = from;
    to_ = to;
    for (;;) {
      reached_ = kNone;
      next_.clear();
      for (const std::uint32_t s : now_) depart(s);
      now_.swap(next_);
      if (now_.empty()) return false;
      before_ = at_;
      if (reached_ == kNone) return true;
      at_ = tri_.points[reached_];
      if (at_ == to_) return true;
    }
  }

  void depart(std::uint32_t s) {
    parent_ = s;
    const std::uint32_t t = states_[s].triangle;
    for (int i = 0; i < 3; ++i)
      if (corner(t, i) == at_) return depart_from_vertex(t, i);
    begin_option(states_[s].loose);
    enter(t);
  }

  void begin_option(std::uint32_t loose) {
    loose_ = loose;
    first_ = static_cast<std::uint32_t>(passed_.size());
  }

  /// By any way within the sector: turning around the vertex to the left or to the right, as far as there are
  /// triangles.
  void depart_from_vertex(std::uint32_t t, int i) {
    fan_.assign(1, t);
    leave_from(t, i, 0);
    bool is_full = false;
    for (std::uint32_t u = t; !is_full && !tri_.is_constrained(u, Tri::ccw(tri_.corner(u, vertex_of(t, i))));) {
      u = tri_.ccw_triangle(u, tri_.corner(u, vertex_of(t, i)));
      is_full = u == t;
      if (is_full) break;
      fan_.push_back(u);
      leave_from(u, tri_.corner(u, vertex_of(t, i)), 1);
    }
    fan_.assign(1, t);
    for (std::uint32_t u = t; !is_full && !tri_.is_constrained(u, Tri::cw(tri_.corner(u, vertex_of(t, i))));) {
      u = tri_.cw_triangle(u, tri_.corner(u, vertex_of(t, i)));
      fan_.push_back(u);
      leave_from(u, tri_.corner(u, vertex_of(t, i)), -1);
    }
  }

  std::uint32_t vertex_of(std::uint32_t t, int i) const { return tri_.triangles[t][i]; }

  /// Into triangle t of the fan, or along one of its sides. (An unconstrained side belongs to the triangle on its
  /// left.) `turned`: +1 when the fan was passed counter-clockwise, which leaves the vertex on the left.
  void leave_from(std::uint32_t t, int i, int turned) {
    const Point right = corner(t, Tri::ccw(i)), left = corner(t, Tri::cw(i));
    const int r = side(right), l = side(left);
    const bool along_right = r == 0 && is_ahead(right);
    const bool along_left = l == 0 && is_ahead(left) && tri_.is_constrained(t, Tri::ccw(i));
    if (!(r < 0 && l > 0) && !along_right && !along_left) return;
    begin_option(states_[parent_].loose + is_loose(turned));
    passed_.insert(passed_.end(), fan_.begin() + 1, fan_.end());
    if (holds(t, to_)) return arrive(t, kNone);
    if (along_right) return arrive(t, tri_.triangles[t][Tri::ccw(i)]);
    if (along_left) return arrive(t, tri_.triangles[t][Tri::cw(i)]);
    pass(t, i);
  }

  bool is_loose(int turned) const {
    if (states_[parent_].parent == kNone) return false;
    const int turn = written::orientation(before_, at_, to_);
    const bool is_straight = turn == 0 && !is_ahead(before_);
    return !is_straight && (turned == 0 || turn * turned < 0);
  }

  /// From a point of the closed triangle that is no corner.
  void enter(std::uint32_t t) {
    if (holds(t, to_)) return arrive(t, kNone);
    int sides[3];
    for (int i = 0; i < 3; ++i) sides[i] = side(corner(t, i));
    for (int i = 0; i < 3; ++i)
      if (sides[i] == 0 && is_ahead(corner(t, i))) return arrive(t, tri_.triangles[t][i]);
    for (int i = 0; i < 3; ++i)
      if (sides[Tri::ccw(i)] < 0 && sides[Tri::cw(i)] > 0) return pass(t, i);
  }

  /// Out of t by side i and on, to a vertex, the end of the leg, or a constraint.
  void pass(std::uint32_t t, int i) {
    for (;;) {
      if (written::orientation(corner(t, Tri::ccw(i)), corner(t, Tri::cw(i)), to_) >= 0) return arrive(t, kNone);
      if (tri_.is_constrained(t, i) || tri_.neighbours[t][i] == kNone) return;
      const std::uint32_t n = tri_.neighbours[t][i];
      const int k = tri_.mirror(t, i), turn = side(corner(n, k));
      passed_.push_back(n);
      if (turn == 0) return arrive(n, holds(n, to_) ? kNone : tri_.triangles[n][k]);
      t = n;
      i = turn > 0 ? Tri::ccw(k) : Tri::cw(k);
    }
  }

  /// Of two states in one triangle the cheaper one stays.
  void arrive(std::uint32_t t, std::uint32_t vertex) {
    reached_ = vertex;
    const State state{t, parent_, loose_, first_, static_cast<std::uint32_t>(passed_.size())};
    for (const std::uint32_t s : next_)
      if (states_[s].triangle == t) {
        if (state.loose < states_[s].loose) states_[s] = state;
        return;
      }
    next_.push_back(static_cast<std::uint32_t>(states_.size()));
    states_.push_back(state);
  }

  /// From the start to the best of the last states, without turning back.
  std::vector<std::uint32_t> triangles() const {
    const auto is_cheaper = [&](std::uint32_t a, std::uint32_t b) { return states_[a].loose < states_[b].loose; };
    std::vector<std::uint32_t> chain;
    for (std::uint32_t s = *std::min_element(now_.begin(), now_.end(), is_cheaper); s != kNone; s = states_[s].parent)
      chain.push_back(s);
    std::reverse(chain.begin(), chain.end());
    std::vector<std::uint32_t> result;
    for (const std::uint32_t s : chain)
      for (std::uint32_t k = states_[s].first; k < states_[s].last; ++k) append(result, passed_[k]);
    return result;
  }

  static void append(std::vector<std::uint32_t>& walk, std::uint32_t t) {
    if (walk.size() > 1 && walk[walk.size() - 2] == t)
      walk.pop_back();
    else if (walk.empty() || walk.back() != t)
      walk.push_back(t);
  }

  const FreeSpace& space_;
  const Tri& tri_;
  std::vector<State> states_;
  std::vector<std::uint32_t> passed_, now_, next_, fan_;
  Point before_, at_, to_;                            // the last point but one, the current one, the end of the leg
  std::uint32_t reached_ = kNone;                     // the vertex that the states come to; kNone: the end of the leg
  std::uint32_t parent_ = 0, loose_ = 0, first_ = 0;  // of the state in the making
};

}  // namespace

std::optional<Corridor> corridor_of(const FreeSpace& space, std::span<const Point> points) {
  return CorridorWalk(space).run(points);
}

}  // namespace taut
