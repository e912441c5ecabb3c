#include <algorithm>
#include <cmath>

#include <taut/geometry/written.h>
#include <taut/roadmaps/detail/voronoi_parts.h>
#include <taut/roadmaps/voronoi.h>

namespace taut {

namespace {

constexpr double kStraightOff = 1e-9;  // of a piece's length, between the feet of an edge's ends

/// Of the edges around a site's cell, which cover all directions from an end, or all feet on one side of a piece, the
/// one that is met. Chosen by the largest margin, so rounding leaves no gap.
class Join {
 public:
  explicit Join(const detail::VoronoiParts& parts) : parts_(parts) {}

  /// From the foot at `along` times the length of the piece, to the left (side > 0) or the right.
  void off_piece(std::uint32_t piece, double along, int side) {
    const Segment s = parts_.segment(piece);
    const Point d{s.b.x - s.a.x, s.b.y - s.a.y};
    const auto foot = [&](Point p) { return ((p.x - s.a.x) * d.x + (p.y - s.a.y) * d.y) / (d.x * d.x + d.y * d.y); };
    const auto height = [&](Point p) { return (d.x * (p.y - s.a.y) - d.y * (p.x - s.a.x)) * side; };
    pick(piece, [&](const Bezier& c) -> Hit {
      if (height(c.at(0.5)) <= 0) return {-HUGE_VAL, 0};
      const double x0 = foot(c.from), x1 = foot(c.to);
      const double margin = std::min(along - std::min(x0, x1), std::max(x0, x1) - along);
      // Straight off the piece, at a joint: its far end is where the cell ends, and mostly another edge's as well.
      if (std::abs(x1 - x0) < kStraightOff) return {margin - 1, height(c.from) < height(c.to) ? 1.0 : 0.0};
      return {margin, std::clamp((along - x0) / (x1 - x0), 0.0, 1.0)};
    });
  }

  /// From the end of pieces towards p.
  void off_end(std::uint32_t end, Point p) {
    const Point e = parts_.segment(end).a;
    const Point u = unit(e, p);
    pick(end, [&](const Bezier& c) -> Hit {
      const auto side = [&](Point q) { return u.x * (q.y - e.y) - u.y * (q.x - e.x); };
      const auto turn = [&](Point q) {
        const Point w = unit(e, q);
        return std::atan2(u.x * w.y - u.y * w.x, u.x * w.x + u.y * w.y);
      };
      const double a0 = turn(c.from), a1 = turn(c.to);
      const double margin = std::abs(a1 - a0) > 1.5 * M_PI ? -HUGE_VAL : std::min(-std::min(a0, a1), std::max(a0, a1));
      return {margin, crossing(side(c.from), side(c.control), side(c.to))};
    });
  }

  /// From the joint of pieces that go straight on there towards p: the joint has no cell of its own, the pieces have.
  void off_straight_joint(Point end, Point p) {
    const auto& pieces = parts_.space.constraints();
    const Point u = unit(end, p);
    for (std::uint32_t i = 0; i < pieces.size() && found.empty(); ++i) {
      if (pieces[i].a != end && pieces[i].b != end) continue;
      const Point d = unit(pieces[i].a, pieces[i].b);
      if (std::abs(d.x * u.x + d.y * u.y) < 1e-9)
        off_piece(i, pieces[i].a == end ? 0 : 1, written::orientation(pieces[i].a, pieces[i].b, p));
    }
  }

  /// At an end of pieces: straight off each of them there, and to the ends of all edges of the end's own cell.
  void at_end(std::uint32_t end, Point p) {
    const auto& pieces = parts_.space.constraints();
    for (std::uint32_t i = 0; i < pieces.size(); ++i)
      if (pieces[i].a == p || pieces[i].b == p) off_both_sides(i, pieces[i].a == p ? 0 : 1);
    for (const std::uint32_t e : parts_.beside_site.row(end))
      for (const double t : {0.0, 1.0}) add(e, t);
  }

  void off_both_sides(std::uint32_t piece, double along) {
    if (!parts_.space.constraints()[piece].solid_left) off_piece(piece, along, 1);
    if (!parts_.space.constraints()[piece].solid_right) off_piece(piece, along, -1);
  }

  std::vector<VoronoiJunction> found;

 private:
  struct Hit {
    double margin;
    double parameter;
  };

  static Point unit(Point from, Point to) {
    const double x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
    return {x / length, y / length};
  }

  /// Where the quadratic with these Bernstein coefficients changes sign; an end when it does not.
  static double crossing(double c0, double c1, double c2) {
    if (c0 == 0 || (c0 > 0) == (c2 > 0)) return std::abs(c0) <= std::abs(c2) ? 0 : 1;
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double t = low + (high - low) / 2, s = 1 - t;
      ((s * s * c0 + 2 * s * t * c1 + t * t * c2 > 0) == (c0 > 0) ? low : high) = t;
    }
    return low;
  }

  void add(std::uint32_t edge, double t) { found.push_back({edge, t, parts_.curve(parts_.edges[edge]).at(t)}); }

  template <class Try>
  void pick(std::uint32_t site, Try hit_of) {
    Hit best{-HUGE_VAL, 0};
    std::uint32_t edge = kNone;
    for (const std::uint32_t e : parts_.beside_site.row(site))
      if (const Hit hit = hit_of(parts_.curve(parts_.edges[e])); hit.margin > best.margin) best = hit, edge = e;
    if (edge != kNone) add(edge, best.parameter);
  }

  const detail::VoronoiParts& parts_;
};

/// The site of an end of a piece: they come after the pieces, sorted.
std::uint32_t end_site(const detail::VoronoiParts& parts, Point p) {
  std::uint32_t low = static_cast<std::uint32_t>(parts.space.constraints().size());
  std::uint32_t high = static_cast<std::uint32_t>(parts.sites.size());
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (parts.segment(middle).a < p)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

}  // namespace

std::vector<VoronoiJunction> VoronoiRoadmap::join(Point p) const {
  const Clearance nearest = space().clearance(p);
  if (nearest.constraint == kNone) return {};
  const Constraint& c = space().constraints()[nearest.constraint];
  Join join(*impl_);
  const double dx = c.b.x - c.a.x, dy = c.b.y - c.a.y;
  const double along = ((p.x - c.a.x) * dx + (p.y - c.a.y) * dy) / (dx * dx + dy * dy);
  if (p == c.a || p == c.b) {
    join.at_end(end_site(*impl_, p), p);
  } else if (nearest.distance == 0) {
    join.off_both_sides(nearest.constraint, along);
  } else if (along >= -1e-14 && along <= 1 + 1e-14) {
    join.off_piece(nearest.constraint, along, written::orientation(c.a, c.b, p));
  } else {
    const Point end = along < 0 ? c.a : c.b;
    join.off_end(end_site(*impl_, end), p);
    if (join.found.empty()) join.off_straight_joint(end, p);
  }
  return std::move(join.found);
}

}  // namespace taut
