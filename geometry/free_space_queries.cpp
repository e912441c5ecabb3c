#include <algorithm>
#include <limits>
#include <unordered_set>

#include <taut/geometry/detail/free_space_impl.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/expects.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/triangular_expansion.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

using Tri = Triangulation;

/// The nearest constraint, searched outwards through the sides that are no farther than the best so far: nothing stands
/// between p and the nearest obstacle.
class NearestConstraint {
 public:
  NearestConstraint(const FreeSpace& space, const std::vector<std::uint32_t>& piece_of, Point p)
      : space_(space), tri_(space.triangulation()), piece_of_(piece_of), p_(p) {}

  Clearance search(const Location& at) {
    if (at.kind == Location::Kind::vertex)
      each_around(tri_.triangles[at.triangle][at.index], [&](std::uint32_t t) { reach(t); });
    else
      reach(at.triangle);
    for (std::size_t k = 0; k < open_.size(); ++k)
      for (int i = 0; i < 3; ++i) leave(open_[k], i);
    if (best_ == kNone) return {std::numeric_limits<double>::infinity(), kNone};
    // At a nearest point that is an end, others can meet without being seen from p.
    const std::uint32_t nearest = best_;
    for (const std::uint32_t piece : std::vector(considered_))
      for (const Point end : {space_.constraints()[piece].a, space_.constraints()[piece].b})
        if (is_equal({end, end}, side(nearest))) consider_around(end);
    return {segment_distance(here(), side(best_)), best_};
  }

 private:
  Segment here() const { return {p_, p_}; }
  Segment side(std::uint32_t piece) const { return {space_.constraints()[piece].a, space_.constraints()[piece].b}; }

  void reach(std::uint32_t t) {
    if (seen_.insert(t).second) open_.push_back(t);
  }

  void leave(std::uint32_t t, int i) {
    if (const std::uint32_t piece = piece_of_[3 * t + i]; piece != kNone) return consider(piece);
    const Point a = tri_.points[tri_.triangles[t][Tri::ccw(i)]], b = tri_.points[tri_.triangles[t][Tri::cw(i)]];
    if (segment_distance_interval(here(), {a, b}).lo <= least_.hi) reach(tri_.neighbours[t][i]);
  }

  bool is_equal(const Segment& s, const Segment& t) const {
    return compare_segment_distances(here(), s, here(), t) == 0;
  }

  void consider(std::uint32_t piece) {
    considered_.push_back(piece);
    const Interval distance = segment_distance_interval(here(), side(piece));
    if (best_ == kNone || is_better(piece, distance)) {
      best_ = piece;
      least_ = distance;
    }
  }

  bool is_better(std::uint32_t piece, const Interval& distance) const {
    if (piece == best_ || distance.lo > least_.hi) return false;
    if (distance.hi < least_.lo) return true;
    const int order = compare_segment_distances(here(), side(piece), here(), side(best_));
    return order != 0 ? order < 0 : piece < best_;
  }

  void consider_around(Point end) {
    const Location at = space_.locate(end);
    if (at.kind != Location::Kind::vertex) return;
    const std::uint32_t v = tri_.triangles[at.triangle][at.index];
    each_around(v, [&](std::uint32_t t) {
      for (int i = 0; i < 3; ++i)
        if (tri_.triangles[t][i] != v && piece_of_[3 * t + i] != kNone) consider(piece_of_[3 * t + i]);
    });
  }

  /// Every free triangle at a vertex.
  void each_around(std::uint32_t v, const auto& visit) {
    for (const Tri::Sector& sector : tri_.sectors_at(v))
      each_triangle(tri_, sector, [&](std::uint32_t t, int) { visit(t); });
  }

  const FreeSpace& space_;
  const Tri& tri_;
  const std::vector<std::uint32_t>& piece_of_;
  Point p_;
  std::vector<std::uint32_t> open_;
  std::unordered_set<std::uint32_t> seen_;
  std::vector<std::uint32_t> considered_;
  Interval least_{0, std::numeric_limits<double>::infinity()};
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
    expansion_.spread(origin_, t, i, expansion_.ray(tri_.triangles[t][Tri::ccw(i)]),
                      expansion_.ray(tri_.triangles[t][Tri::cw(i)]));
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
      if (written::orientation(origin_, ray.through, p) == 0) return p;
    const ExactPoint exact = line_crossing({origin_, ray.through}, {a, b});
    const Point p = nearest_point(exact);
    result_.rounding = std::max(result_.rounding, displacement(exact, p));
    return p;
  }

  const Tri& tri_;
  Point origin_;
  Expansion<DoubleCoordinates, Outline> expansion_;
  VisibilityPolygon result_;
};

}  // namespace

Clearance FreeSpace::clearance(Point p) const {
  const Location at = locate(p);
  TAUT_EXPECTS(at.kind != Location::Kind::outside);
  return NearestConstraint(*this, impl_->parts().piece_of, p).search(at);
}

VisibilityPolygon FreeSpace::visibility_polygon(Point p) const {
  const Tri& tri = impl_->parts().tri;
  const Location at = locate(p);
  TAUT_EXPECTS(at.kind != Location::Kind::outside);
  Outline outline(tri, p);
  if (at.kind == Location::Kind::triangle) {
    outline.whole(at.triangle);
  } else if (at.kind == Location::Kind::side) {
    const std::uint32_t n = tri.neighbours[at.triangle][at.index];
    outline.triangle(at.triangle, at.index);
    if (n != kNone && tri.free[n])
      outline.triangle(n, tri.mirror(at.triangle, at.index));
    else
      outline.add(p);
  } else if (at.kind == Location::Kind::vertex) {
    for (const Tri::Sector& sector : tri.sectors_at(tri.triangles[at.triangle][at.index])) {
      each_triangle(tri, sector, [&](std::uint32_t t, int i) { outline.out_of(t, i); });
      if (!sector.full && sector.left != sector.right) outline.add(p);
    }
  }
  return outline.finish();
}

}  // namespace taut
