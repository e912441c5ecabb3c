#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <taut/geometry/detail/exact.h>
#include <taut/geometry/detail/expansion.h>
#include <taut/geometry/detail/free_space_impl.h>
#include <taut/geometry/predicates.h>

namespace taut {

namespace {

using Tri = Triangulation;

/// The squared distance from p to the closed segment a b, exactly.
mpq_class exact_squared_distance(Point p, Point a, Point b) {
  const detail::ExactPoint ep(p), ea(a), eb(b);
  const mpq_class dx = eb.x - ea.x, dy = eb.y - ea.y, px = ep.x - ea.x, py = ep.y - ea.y;
  const mpq_class along = px * dx + py * dy, length = dx * dx + dy * dy;
  if (sgn(along) <= 0) return px * px + py * py;
  if (along >= length) {
    const mpq_class qx = ep.x - eb.x, qy = ep.y - eb.y;
    return qx * qx + qy * qy;
  }
  const mpq_class cross = dx * py - dy * px;
  return cross * cross / length;
}

/// The same in doubles, good to kSlack of itself plus kSlack of the coordinates' squared extent.
constexpr double kSlack = 1e-12;
double squared_distance(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const double along = px * dx + py * dy, length = dx * dx + dy * dy;
  const double t = std::clamp(along / length, 0.0, 1.0), x = px - t * dx, y = py - t * dy;
  return x * x + y * y;
}

/// The nearest constraint, searched outwards through the sides that are nearer than the best so far: nothing stands between p
/// and the nearest obstacle.
class NearestConstraint {
 public:
  NearestConstraint(const FreeSpace& space, const std::vector<std::uint32_t>& piece_of, Point p)
      : space_(space), tri_(space.triangulation()), piece_of_(piece_of), p_(p) {}

  Clearance search(std::uint32_t first) {
    seen_.insert(first);
    std::vector<std::uint32_t> open{first};
    for (std::size_t k = 0; k < open.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t t = open[k], piece = piece_of_[3 * t + i];
        if (piece != kNone) consider(piece);
        else if (near(t, i) && seen_.insert(tri_.neighbours[t][i]).second) open.push_back(tri_.neighbours[t][i]);
      }
    if (best_ == kNone) return {std::numeric_limits<double>::infinity(), kNone};
    return {std::sqrt(exact(best_).get_d()), best_};
  }

 private:
  bool near(std::uint32_t t, int i) const {
    const Point a = tri_.points[tri_.triangles[t][Tri::ccw(i)]], b = tri_.points[tri_.triangles[t][Tri::cw(i)]];
    return squared_distance(p_, a, b) <= least_ + slack(a, b);
  }

  void consider(std::uint32_t piece) {
    const Constraint& c = space_.constraints()[piece];
    const double d = squared_distance(p_, c.a, c.b), s = slack(c.a, c.b);
    if (best_ != kNone && d > least_ + s) return;
    if (best_ == kNone || d < least_ - s || is_nearer(piece)) best_ = piece;
    least_ = std::min(least_, d);
  }

  bool is_nearer(std::uint32_t piece) const {
    const int order = cmp(exact(piece), exact(best_));
    return order != 0 ? order < 0 : piece < best_;
  }

  double slack(Point a, Point b) const {
    const double extent = std::max({std::abs(a.x - p_.x), std::abs(a.y - p_.y), std::abs(b.x - p_.x), std::abs(b.y - p_.y)});
    return kSlack * extent * extent;
  }

  mpq_class exact(std::uint32_t piece) const {
    const Constraint& c = space_.constraints()[piece];
    return exact_squared_distance(p_, c.a, c.b);
  }

  const FreeSpace& space_;
  const Tri& tri_;
  const std::vector<std::uint32_t>& piece_of_;
  Point p_;
  std::unordered_set<std::uint32_t> seen_;
  double least_ = std::numeric_limits<double>::infinity();
  std::uint32_t best_ = kNone;
};

/// Collects the outline of what is seen, counter-clockwise.
class Outline {
 public:
  Outline(const Tri& tri, Point origin) : tri_(tri), origin_(origin), expansion_(tri, *this) {}

  void triangle(std::uint32_t t, int except) {
    // From the corner after the excepted side, so that an origin on that side sees its half-plane in order.
    for (int k = 1; k <= 3; ++k) {
      const int i = (except + k) % 3;
      if (i != except || k != 3) out_of(t, i);
    }
  }

  void whole(std::uint32_t t) {
    for (int i = 0; i < 3; ++i) out_of(t, i);
  }

  void out_of(std::uint32_t t, int i) {
    expansion_.spread(origin_, t, i, expansion_.ray(tri_.triangles[t][Tri::ccw(i)]), expansion_.ray(tri_.triangles[t][Tri::cw(i)]));
  }

  void add(Point p) {
    if (result_.ring.empty() || result_.ring.back() != p) result_.ring.push_back(p);
  }

  VisibilityPolygon finish() {
    while (result_.ring.size() > 1 && result_.ring.back() == result_.ring.front()) result_.ring.pop_back();
    return std::move(result_);
  }

  // What the expansion calls.
  bool hides(std::uint32_t) const { return true; }
  void vertex(std::uint32_t, int) {}
  void blocked(std::uint32_t t, int i, const auto& right, const auto& left) {
    const Point a = tri_.points[tri_.triangles[t][Tri::ccw(i)]], b = tri_.points[tri_.triangles[t][Tri::cw(i)]];
    add(end_of(right, a, b));
    add(end_of(left, a, b));
  }

 private:
  /// Where a ray meets the side a b.
  Point end_of(const auto& ray, Point a, Point b) {
    for (const Point p : {a, b})
      if (orientation(origin_, ray.through, p) == 0) return p;
    const detail::ExactPoint exact = detail::line_crossing({origin_, ray.through}, {a, b});
    const Point p = detail::nearest_point(exact);
    result_.rounding = std::max(result_.rounding, detail::displacement(exact, p));
    return p;
  }

  const Tri& tri_;
  Point origin_;
  detail::Expansion<detail::DoubleCoordinates, Outline> expansion_;
  VisibilityPolygon result_;
};

}  // namespace

Clearance FreeSpace::clearance(Point p) const {
  const Location at = locate(p);
  return NearestConstraint(*this, impl_->piece_of, p).search(at.triangle);
}

VisibilityPolygon FreeSpace::visibility_polygon(Point p) const {
  const Tri& tri = impl_->tri;
  const Location at = locate(p);
  Outline outline(tri, p);
  if (at.kind == Location::Kind::triangle) {
    outline.whole(at.triangle);
  } else if (at.kind == Location::Kind::side) {
    const std::uint32_t n = tri.neighbours[at.triangle][at.index];
    outline.triangle(at.triangle, at.index);
    if (n != kNone && tri.free[n]) outline.triangle(n, tri.mirror(at.triangle, at.index));
    else outline.add(p);
  } else if (at.kind == Location::Kind::vertex) {
    for (const Tri::Sector& sector : tri.sectors_at(tri.triangles[at.triangle][at.index])) {
      std::uint32_t t = sector.triangle;
      do {
        const int i = tri.corner(t, sector.vertex);
        outline.out_of(t, i);
        if (tri.is_constrained(t, Tri::ccw(i))) break;
        t = tri.ccw_triangle(t, i);
      } while (t != sector.triangle);
      if (!sector.full && sector.left != sector.right) outline.add(p);
    }
  }
  return outline.finish();
}

}  // namespace taut
