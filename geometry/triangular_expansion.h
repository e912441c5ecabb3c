// Triangular expansion: what is seen from a place, triangle by triangle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <taut/geometry/triangulation.h>
#include <taut/geometry/written.h>

namespace taut {

/// The vertices of a triangulation as integers; places are compared in int64, exactly.
class LatticeCoordinates {
 public:
  using Place = std::array<std::int32_t, 2>;

  explicit LatticeCoordinates(const Triangulation& tri) : points_(tri.lattice.data()) {}
  Place at(std::uint32_t v) const { return points_[v]; }
  static int side(Place a, Place b, Place c) {
    // Differences below 2^30, products below 2^60.
    const std::int64_t left = std::int64_t{b[0] - a[0]} * (c[1] - a[1]),
                       right = std::int64_t{b[1] - a[1]} * (c[0] - a[0]);
    return (left > right) - (left < right);
  }

 private:
  const Place* points_;
};

/// The vertices as doubles; places are compared by filtered exact predicates.
class DoubleCoordinates {
 public:
  using Place = Point;

  explicit DoubleCoordinates(const Triangulation& tri) : points_(tri.points.data()) {}
  Place at(std::uint32_t v) const { return points_[v]; }
  static int side(Place a, Place b, Place c) { return written::orientation(a, b, c); }

 private:
  const Point* points_;
};

/// Spreads the view from one place through unconstrained sides.
///
/// A view is a cone between two rays, each from the origin through a vertex, or away from one (`away`), and shrinks at
/// every vertex it meets; it is never empty. It is passed on closed: a vertex on a bounding ray is seen along the
/// obstacle that the ray touches. Calls, counter-clockwise:
///  - visitor.vertex(t, k): corner k of triangle t is seen through t, unless it lies on a ray behind a vertex v with
///    visitor.hides(v);
///  - visitor.blocked(t, i, right, left): the view ends at the constrained side i of t;
///  - visitor.skips(t, i, right, left), where there is one: is nothing wanted that this view shows beyond side i of t?
/// O(triangles seen), each counted once a cone. Source: Bungiu et al., "Efficient computation of visibility polygons"
/// (2014).
template <class Coordinates, class Visitor>
class Expansion {
 public:
  using Place = typename Coordinates::Place;

  struct Ray {
    Place through;
    std::uint32_t vertex = kNone;
    bool away = false;
  };

  Expansion(const Triangulation& tri, Visitor& visitor) : tri_(tri), at_(tri), visitor_(visitor) {}

  Ray ray(std::uint32_t v, bool away = false) const { return {at_.at(v), v, away}; }
  const Coordinates& coordinates() const { return at_; }

  /// The view from `origin` between `right` and `left` out of triangle t through side i.
  void spread(Place origin, std::uint32_t t, int i, const Ray& right, const Ray& left) {
    origin_ = origin;
    stack_.clear();
    enter(t, i, right, left);
    while (!stack_.empty()) {
      const View view = stack_.back();
      stack_.pop_back();
      if constexpr (requires { visitor_.skips(view.t, view.i, view.right, view.left); })
        if (visitor_.skips(view.t, view.i, view.right, view.left)) continue;
      if (tri_.is_constrained(view.t, view.i)) {
        visitor_.blocked(view.t, view.i, view.right, view.left);
        continue;
      }
      const std::uint32_t n = tri_.neighbours[view.t][view.i];
      advance(n, tri_.mirror(view.t, view.i), view.right, view.left);
    }
  }

 private:
  struct View {
    std::uint32_t t;
    int i;
    Ray right, left;
  };

  void enter(std::uint32_t t, int i, const Ray& right, const Ray& left) { stack_.push_back({t, i, right, left}); }

  int side(const Ray& ray, Place p) const {
    const int s = Coordinates::side(origin_, ray.through, p);
    return ray.away ? -s : s;
  }

  bool hides(const Ray& ray) const { return !ray.away && visitor_.hides(ray.vertex); }

  /// Into triangle t, whose corner k lies beyond the side it is entered by.
  void advance(std::uint32_t t, int k, const Ray& right, const Ray& left) {
    const Place apex = at_.at(tri_.triangles[t][k]);
    const int r = side(right, apex);
    if (r < 0) return enter(t, Triangulation::cw(k), right, left);
    const int l = side(left, apex);
    if (l > 0) return enter(t, Triangulation::ccw(k), right, left);
    const Ray middle{apex, tri_.triangles[t][k], false};
    // An apex on a bounding ray, behind a vertex that hides it, leaves that vertex in charge.
    const bool on_right = r == 0 && hides(right), on_left = l == 0 && hides(left);
    if (l < 0) enter(t, Triangulation::cw(k), on_right ? right : middle, left);
    if (r > 0) enter(t, Triangulation::ccw(k), right, on_left ? left : middle);
    if (!on_right && !on_left) visitor_.vertex(t, k);
  }

  const Triangulation& tri_;
  Coordinates at_;
  Visitor& visitor_;
  Place origin_{};
  std::vector<View> stack_;
};

}  // namespace taut
