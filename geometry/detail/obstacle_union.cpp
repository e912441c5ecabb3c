#include <taut/geometry/detail/obstacle_union.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <taut/geometry/box_index.h>
#include <taut/geometry/detail/cut_axis.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

struct Span {
  Cut from;
  Cut to;
};

/// The part of a side that another convex piece hides from the free space, if any.
class Cover {
 public:
  Cover(const Segment& side, const Axis& axis) : side_(side), axis_(axis) {}

  /// `first`: the other piece goes first where both have the same stretch of outline.
  std::optional<Span> by(const Ring& ring, bool first) {
    signs_.resize(ring.size());
    int least = 1, greatest = -1;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      signs_[i] = written::orientation(side_.a, side_.b, ring[i]);
      least = std::min(least, signs_[i]);
      greatest = std::max(greatest, signs_[i]);
    }
    if (least < 0 && greatest > 0) return across(ring);
    if (greatest <= 0 || first) return along(ring);
    return std::nullopt;
  }

 private:
  /// The ring has a side on the line.
  std::optional<Span> along(const Ring& ring) const {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      if (signs_[i] == 0 && signs_[j] == 0) return ordered(axis_.at(ring[i]), axis_.at(ring[j]));
    return std::nullopt;
  }

  /// The line passes through the ring's inside.
  std::optional<Span> across(const Ring& ring) const {
    std::array<Cut, 2> cuts;
    std::size_t count = 0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size() && count < 2; j = i++) {
      if (signs_[i] == 0)
        cuts[count++] = axis_.at(ring[i]);
      else if (signs_[i] * signs_[j] < 0)
        cuts[count++] = axis_.crossing({ring[j], ring[i]});
    }
    return ordered(cuts[0], cuts[1]);
  }

  Span ordered(const Cut& c, const Cut& d) const { return axis_.compare(c, d) <= 0 ? Span{c, d} : Span{d, c}; }

  Segment side_;
  const Axis& axis_;
  std::vector<int> signs_;
};

/// A stretch of outline; ends that are no doubles wait for their rounding.
struct Stretch {
  Segment side;
  std::uint32_t wall;
  Point from, to;
  bool bent = false;  // an end was rounded
};

struct Incidence {
  std::size_t stretch;
  bool leaves;
};

constexpr double kSure = 1e-13;  // of what is multiplied: far above all roundings
constexpr int kHalvings = 2;

class Union {
 public:
  Union(const std::vector<ConvexPiece>& pieces, const Box& within, std::span<const Point> fixed)
      : pieces_(pieces), within_(within), fixed_(fixed), unit_(within), boxes_(boxes(pieces)), index_(boxes_) {}

  Outline run() {
    for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
      const Ring& ring = pieces_[p].ring;
      find_near(p);
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        if (const Segment side{ring[j], ring[i]}; !are_hidden(side.a, side.b, kHalvings)) expose(p, side);
    }
    for (const auto& [place, incidences] : crossings_) settle(place, incidences);
    outline_.crossings = crossings_.size();
    for (const Stretch& s : stretches_)
      if (s.from != s.to && within_.contains(s.from) && within_.contains(s.to)) draw(s);
    return std::move(outline_);
  }

 private:
  static std::vector<Box> boxes(const std::vector<ConvexPiece>& pieces) {
    std::vector<Box> result;
    result.reserve(pieces.size());
    for (const ConvexPiece& piece : pieces) {
      Box box{piece.ring[0], piece.ring[0]};
      for (const Point p : piece.ring) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
      }
      result.push_back(box);
    }
    return result;
  }

  void find_near(std::uint32_t p) {
    near_.clear();
    index_.meeting(boxes_[p], [&](std::uint32_t q) {
      if (q != p) near_.push_back(q);
    });
  }

  /// Do the others surely have all from a to b inside? One of them, or one for each half. Where pieces lie thick on one
  /// another nearly all sides are hidden, and mostly by what hid the side before: that is asked first.
  bool are_hidden(Point a, Point b, int halvings) {
    for (std::uint32_t& q : near_)
      if (surely_holds(q, a) && surely_holds(q, b)) {
        std::swap(q, near_.front());
        return true;
      }
    if (halvings == 0) return false;
    const Point middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
    return are_hidden(a, middle, halvings - 1) && are_hidden(middle, b, halvings - 1);
  }

  /// Also when p is off by some roundings.
  bool surely_holds(std::uint32_t piece, Point p) const {
    const Box& box = boxes_[piece];
    if (p.x <= box.min.x || p.x >= box.max.x || p.y <= box.min.y || p.y >= box.max.y) return false;
    const Ring& ring = pieces_[piece].ring;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const double x = ring[i].x - ring[j].x, y = ring[i].y - ring[j].y;
      const double size = std::abs(p.x) + std::abs(p.y) + std::abs(ring[j].x) + std::abs(ring[j].y);
      if (x * (p.y - ring[j].y) - y * (p.x - ring[j].x) <= kSure * (std::abs(x) + std::abs(y)) * size) return false;
    }
    return true;
  }

  /// Finds what remains of a side of piece p.
  void expose(std::uint32_t p, const Segment& side) {
    const Axis axis(side);
    Cover cover(side, axis);
    covered_.clear();
    index_.meeting(box_around(side.a, side.b), [&](std::uint32_t q) {
      if (q == p) return;
      if (const auto span = cover.by(pieces_[q].ring, q < p)) covered_.push_back(*span);
    });
    std::sort(covered_.begin(), covered_.end(),
              [&](const Span& c, const Span& d) { return axis.compare(c.from, d.from) < 0; });
    Cut reached = axis.at(side.a);
    const Cut end = axis.at(side.b);
    for (const Span& c : covered_) {
      if (axis.compare(c.from, end) >= 0) break;
      if (axis.compare(reached, c.from) < 0) add(p, side, axis, reached, c.from);
      if (axis.compare(reached, c.to) < 0) reached = c.to;
    }
    if (axis.compare(reached, end) < 0) add(p, side, axis, reached, end);
  }

  void add(std::uint32_t p, const Segment& side, const Axis& axis, const Cut& from, const Cut& to) {
    stretches_.push_back({side, pieces_[p].wall, from.point, to.point});
    if (from.line) await(axis.exact(from), true);
    if (to.line) await(axis.exact(to), false);
  }

  void await(ExactPoint place, bool leaves) { crossings_[std::move(place)].push_back({stretches_.size() - 1, leaves}); }

  /// Places a crossing: exactly, or rounded once for each free wedge at it.
  void settle(const ExactPoint& place, const std::vector<Incidence>& incidences) {
    if (const auto p = exactly(place)) {
      for (const Incidence& i : incidences) end_of(i) = *p;
      return;
    }
    for (const Incidence& out : incidences) {
      if (!out.leaves) continue;
      const Incidence& in = partner(out, incidences);
      const Segment edges[] = {stretches_[in.stretch].side, stretches_[out.stretch].side};
      const Point p = round_outward_or_nearest(place, edges, unit_);
      outline_.displacement = std::max(outline_.displacement, displacement(place, p));
      end_of(in) = end_of(out) = p;
      stretches_[in.stretch].bent = stretches_[out.stretch].bent = true;
    }
  }

  /// A bent stretch keeps the fixed points on its side.
  void draw(const Stretch& s) {
    Point reached = s.from;
    std::vector<Point> stops;
    for (const Point p : fixed_)
      if (s.bent && p != s.from && p != s.to && box_around(s.from, s.to).contains(p) &&
          written::on_segment(p, s.side.a, s.side.b))
        stops.push_back(p);
    std::sort(stops.begin(), stops.end(), [&](Point p, Point q) { return (p < q) == (s.side.a < s.side.b) && p != q; });
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    stops.push_back(s.to);
    for (const Point p : stops) {
      outline_.edges.push_back({reached, p, 1, s.wall});
      reached = p;
    }
  }

  Point& end_of(const Incidence& i) { return i.leaves ? stretches_[i.stretch].from : stretches_[i.stretch].to; }

  /// The stretch that arrives on the other side of the free wedge to the right of `out`. At a place that is no pair of
  /// doubles as many stretches arrive as leave: all of them end in crossings.
  const Incidence& partner(const Incidence& out, const std::vector<Incidence>& incidences) const {
    const Incidence* best = nullptr;
    for (const Incidence& in : incidences)
      if (!in.leaves && (!best || nearer_clockwise(out, in, *best))) best = &in;
    return *best;
  }

  /// Is the ray back along c met before that along d, turning clockwise from the ray along `out`?
  bool nearer_clockwise(const Incidence& out, const Incidence& c, const Incidence& d) const {
    const ExactPoint o = direction(out, 1), u = direction(c, -1), v = direction(d, -1);
    const int hu = half(o, u), hv = half(o, v);
    return hu != hv ? hu < hv : cross(u, v) < 0;
  }
  ExactPoint direction(const Incidence& i, int factor) const {
    const ExactPoint a(stretches_[i.stretch].side.a), b(stretches_[i.stretch].side.b);
    return {factor * (b.x - a.x), factor * (b.y - a.y)};
  }
  static int cross(const ExactPoint& u, const ExactPoint& v) { return sgn(Rational(u.x * v.y - u.y * v.x)); }
  /// 0: clockwise of o by less than half a turn; 1: by half a turn or more.
  static int half(const ExactPoint& o, const ExactPoint& u) { return cross(o, u) < 0 ? 0 : 1; }

  const std::vector<ConvexPiece>& pieces_;
  Box within_;
  std::span<const Point> fixed_;
  DecimalUnit unit_;
  std::vector<Box> boxes_;
  BoxIndex index_;
  std::vector<std::uint32_t> near_;  // what may hide the sides of a piece
  std::vector<Span> covered_;
  std::vector<Stretch> stretches_;
  std::map<ExactPoint, std::vector<Incidence>> crossings_;
  Outline outline_;
};

/// Joins collinear neighbours where nothing else meets.
std::vector<Edge> join_collinear(const std::vector<Edge>& edges) {
  std::vector<std::uint32_t> by_start(edges.size()), by_end(edges.size());
  for (std::uint32_t i = 0; i < edges.size(); ++i) by_start[i] = by_end[i] = i;
  std::sort(by_start.begin(), by_start.end(), [&](auto i, auto j) { return edges[i].a < edges[j].a; });
  std::sort(by_end.begin(), by_end.end(), [&](auto i, auto j) { return edges[i].b < edges[j].b; });
  // following[i]: the edge that continues edge i straight, if it is the only one there.
  std::vector<std::uint32_t> following(edges.size(), kNone);
  std::vector<bool> continues(edges.size(), false);
  for (std::size_t s = 0, e = 0; s < edges.size(); ++s) {
    const Point p = edges[by_start[s]].a;
    while (e < edges.size() && edges[by_end[e]].b < p) ++e;
    const bool alone =
        e < edges.size() && edges[by_end[e]].b == p && (e + 1 == edges.size() || edges[by_end[e + 1]].b != p) &&
        (s == 0 || edges[by_start[s - 1]].a != p) && (s + 1 == edges.size() || edges[by_start[s + 1]].a != p);
    if (!alone || written::orientation(edges[by_end[e]].a, p, edges[by_start[s]].b) != 0) continue;
    following[by_end[e]] = by_start[s];
    continues[by_start[s]] = true;
  }
  std::vector<Edge> joined;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (continues[i]) continue;
    Edge c = edges[i];
    for (std::uint32_t next = following[i]; next != kNone; next = following[next]) c.b = edges[next].b;
    joined.push_back(c);
  }
  return joined;
}

}  // namespace

Outline outline_of_union(const std::vector<ConvexPiece>& pieces, const Box& within, std::span<const Point> fixed) {
  Outline outline = Union(pieces, within, fixed).run();
  outline.edges = join_collinear(outline.edges);
  return outline;
}

}  // namespace taut::detail
