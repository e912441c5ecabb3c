// The closed walks of a robot that keeps its hand on the wall.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/geometry/length.h>
#include <taut/geometry/triangulation.h>

namespace taut::bug::detail {

/// A constrained side of a free triangle, directed so that the triangle lies to its left.
struct HalfEdge {
  std::uint32_t t = kNone;
  int i = 0;  ///< the corner opposite to the side
};

/// All contours of a triangulation. Each constrained side of a free triangle is in exactly one, once; each sector that
/// is not full is the corner between two consecutive ones. Keeps a reference to the triangulation.
class Contours {
 public:
  struct At {
    std::uint32_t contour = kNone;
    std::uint32_t edge = 0;
  };

  explicit Contours(const Triangulation& tri);

  At at(std::uint32_t t, int i) const { return at_[3 * t + static_cast<std::uint32_t>(i)]; }
  /// The half-edge that leaves the sector's vertex.
  At at(const Triangulation::Sector& sector) const;

  const std::vector<HalfEdge>& edges(std::uint32_t contour) const { return contours_[contour]; }
  Point tail(At at) const;
  Point head(At at) const;
  /// The sector at the tail.
  std::uint32_t sector(At at) const;
  Interval perimeter(std::uint32_t contour) const;

 private:
  HalfEdge next(HalfEdge e) const;

  const Triangulation& tri_;
  std::vector<At> at_;
  std::vector<std::vector<HalfEdge>> contours_;
};

}  // namespace taut::bug::detail
