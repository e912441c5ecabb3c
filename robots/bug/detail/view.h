// What a robot sees from where it stands.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/robots/bug/detail/place.h>

namespace taut::bug::detail {

/// A range, compared exactly.
class SensorRange {
 public:
  explicit SensorRange(double range);

  bool reaches(const Rational& squared) const { return endless_ || squared <= squared_; }
  bool reaches(const ExactPoint& from, const ExactPoint& to) const {
    return endless_ || reaches(squared_distance(from, to));
  }
  double value() const { return value_; }
  const Rational& squared() const { return squared_; }  ///< precondition: it is finite

 private:
  double value_;
  bool endless_;
  Rational squared_;
};

/// All that is seen from a stand within a range: closed, so corners on a ray that touches others count. Keeps
/// references.
class Sight {
 public:
  Sight(const ContourPlaces& places, const Stand& stand, const SensorRange& range);

  /// The corners seen at which the depth jumps: both sides at the corner lie to one hand of the ray to it. By vertex,
  /// ascending.
  const std::vector<std::uint32_t>& corners() const { return corners_; }

  /// How far a contour is in view along one half-edge.
  struct Step {
    enum class Kind {
      vertex,  ///< up to its end
      shadow,  ///< up to where a corner hides it
      range,   ///< up to where it is out of range, short of it by at most 2^-30 of the step; 0 when `from` is
    };
    Kind kind = Kind::vertex;
    ContourPlace end;
    std::uint32_t corner = kNone;  ///< shadow: the vertex that throws it
  };
  /// Precondition: `from` is in view.
  Step step(const ContourPlace& from, Turn turn) const;

  /// For pictures.
  Ring ring() const;

  // What the expansion calls.
  bool hides(std::uint32_t) const { return false; }
  void vertex(std::uint32_t t, int k);
  template <class Ray>
  void blocked(std::uint32_t t, int i, const Ray& right, const Ray& left) {
    pieces_.push_back({t, i, right.vertex, left.vertex});
  }

 private:
  /// A part of a side, between the rays through two vertices.
  struct Piece {
    std::uint32_t t;
    int i;
    std::uint32_t right, left;
  };

  Point point(std::uint32_t v) const { return places_.tri().points[v]; }
  void look();
  bool is_tangent(const Triangulation::Sector& sector) const;
  const Piece* piece_at(const ContourPlace& from, Contours::At edge, Turn turn) const;
  Step within_range(const ContourPlace& from, Contours::At edge, Step step) const;
  Point ray_end(const Piece& piece, std::uint32_t ray) const;
  void clip(Point a, Point b, Ring& ring) const;

  const ContourPlaces& places_;
  const Stand& stand_;
  const SensorRange& range_;
  Spot origin_;
  std::vector<Piece> pieces_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_side_;  // 3 * t + i, index of a piece; sorted
  std::vector<std::uint32_t> corners_;
};

}  // namespace taut::bug::detail
