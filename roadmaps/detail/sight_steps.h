// A triangulation as a view passes through it. Private.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <taut/geometry/triangulation.h>
#include <taut/geometry/written.h>

namespace taut::detail {

/// Places as integers below 2^29 in magnitude: a ray is a vector, whatever it goes through.
class LatticeSight {
 public:
  using Place = std::array<std::int32_t, 2>;
  using Ray = std::array<std::int32_t, 2>;

  explicit LatticeSight(const Triangulation& tri) : LatticeSight(tri.lattice) {}
  /// Of vertices that lie on another lattice.
  explicit LatticeSight(const std::vector<Place>& places) : points_(places.data()) {}

  Place at(std::uint32_t v) const { return points_[v]; }
  void stand_at(std::uint32_t v) { origin_ = points_[v]; }
  void stand_at(Place p) { origin_ = p; }

  Ray through(Place p) const { return {p[0] - origin_[0], p[1] - origin_[1]}; }
  Ray away_from(Place p) const { return {origin_[0] - p[0], origin_[1] - p[1]}; }
  /// The bounds of what lies to the right: upright, but turned so little that no place lies on them, and those straight
  /// above lie between them. Differences of places stay below 2^30.
  static Ray down() { return {1, -kSteep}; }
  static Ray up() { return {-1, kSteep}; }

  /// +1 when the place lies to the left of the ray.
  int side(Ray ray, Place p) const { return cross(ray, through(p)); }
  static bool is_rightward(Ray ray) { return cross(down(), ray) > 0; }
  /// Of a place on the ray's line: is it beyond `from`?
  static bool is_ahead(Ray ray, Place from, Place p) {
    return std::int64_t{ray[0]} * (p[0] - from[0]) + std::int64_t{ray[1]} * (p[1] - from[1]) > 0;
  }

 private:
  static constexpr std::int32_t kSteep = 1 << 30;

  static int cross(Ray a, Ray b) {
    const std::int64_t left = std::int64_t{a[0]} * b[1], right = std::int64_t{a[1]} * b[0];
    return (left > right) - (left < right);
  }

  const Place* points_;
  Place origin_{};
};

/// Places as doubles, compared by filtered exact predicates.
class DoubleSight {
 public:
  using Place = Point;

  struct Ray {
    Point through;
    enum class Kind : std::uint8_t { through, away, down, up } kind = Kind::through;
  };

  explicit DoubleSight(const Triangulation& tri) : points_(tri.points.data()) {}

  Place at(std::uint32_t v) const { return points_[v]; }
  void stand_at(std::uint32_t v) { origin_ = points_[v]; }

  Ray through(Place p) const { return {p, Ray::Kind::through}; }
  Ray away_from(Place p) const { return {p, Ray::Kind::away}; }
  static Ray down() { return {{}, Ray::Kind::down}; }
  static Ray up() { return {{}, Ray::Kind::up}; }

  int side(const Ray& ray, Place p) const {
    switch (ray.kind) {
      case Ray::Kind::through: return written::orientation(origin_, ray.through, p);
      case Ray::Kind::away: return -written::orientation(origin_, ray.through, p);
      case Ray::Kind::down: return p > origin_ ? 1 : -1;
      case Ray::Kind::up: return p > origin_ ? -1 : 1;
    }
    return 0;
  }
  bool is_rightward(const Ray& ray) const {
    return ray.kind == Ray::Kind::away ? ray.through < origin_ : ray.through > origin_;
  }
  /// Of a ray through a place.
  bool is_ahead(const Ray& ray, Place from, Place p) const { return ray.through > origin_ ? p > from : p < from; }

 private:
  const Point* points_;
  Place origin_{};
};

/// What a view meets when it enters a triangle by the side opposite to a corner: that corner, and where it goes on to
/// the left and to the right of it. Step 3 t + k is the one into triangle t towards its corner k.
template <class Place>
struct SightStep {
  Place apex{};
  std::uint32_t vertex = kNone;  ///< the roadmap's, of the corner's sector
  std::uint32_t left = kNone;    ///< the step through the side to the left of the corner; kNone: an obstacle
  std::uint32_t right = kNone;
};

/// The steps of all free triangles.
template <class Sight>
std::vector<SightStep<typename Sight::Place>> sight_steps(const Triangulation& tri, const Sight& sight,
                                                          const std::vector<std::uint32_t>& vertex_of_sector) {
  std::vector<SightStep<typename Sight::Place>> steps(3 * tri.triangles.size());
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t) {
    if (!tri.free[t]) continue;
    for (int k = 0; k < 3; ++k) {
      auto& step = steps[3 * t + static_cast<std::uint32_t>(k)];
      step.apex = sight.at(tri.triangles[t][k]);
      step.vertex = vertex_of_sector[tri.sector_of[3 * t + static_cast<std::uint32_t>(k)]];
      if (tri.is_constrained(t, k) || tri.neighbours[t][k] == kNone) continue;
      const std::uint32_t through = 3 * tri.neighbours[t][k] + static_cast<std::uint32_t>(tri.mirror(t, k));
      steps[3 * t + static_cast<std::uint32_t>(Triangulation::ccw(k))].left = through;
      steps[3 * t + static_cast<std::uint32_t>(Triangulation::cw(k))].right = through;
    }
  }
  return steps;
}

}  // namespace taut::detail
