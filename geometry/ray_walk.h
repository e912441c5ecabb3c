// Going straight through the triangulation, exactly.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <taut/geometry/free_space.h>

namespace taut {

/// The walk of a path straight along the ray from p through q: from vertex to vertex of the triangulation, as long as a
/// robot of vanishing radius gets along: through unconstrained sides, along constrained ones, past a vertex within one
/// sector.
class RayWalk {
 public:
  enum class End { blocked, reached, vertex };

  /// Where the walk stands after a step: at a vertex, in one or two of its sectors (two when it came along a side).
  struct Stand {
    std::uint32_t vertex = kNone;
    std::array<std::uint32_t, 2> sectors{kNone, kNone};
  };

  /// `bounded`: the walk ends at q; else it goes on until it is blocked. Precondition: p != q.
  RayWalk(const Triangulation& tri, Point p, Point q, bool bounded) : tri_(tri), p_(p), q_(q), bounded_(bounded) {}

  /// From p, which lies at `at`, to the first vertex on the way, q, or what blocks. With `towards`, only through the
  /// surroundings of p that look to it.
  End start(const Location& at, std::optional<Point> towards = std::nullopt);
  /// From the vertex where the walk stands to the next one.
  End next();
  /// Puts the walk at a vertex on its ray.
  void stand_at(const Stand& stand) { stand_ = stand; }

  const Stand& stand() const { return stand_; }

 private:
  int side(Point x) const;                ///< of the ray: +1 left
  bool ahead(Point from, Point x) const;  ///< x on the line, beyond `from`
  bool ends_by(Point x) const;            ///< q is not beyond x; both on the line
  Point corner(std::uint32_t t, int i) const { return tri_.points[tri_.triangles[t][i]]; }

  End in_triangle(std::uint32_t t);
  End through(std::uint32_t t, int side);
  End arrive(std::uint32_t t, int corner);
  End from_side(std::uint32_t t, int side, std::optional<Point> towards);
  End from_vertex(std::uint32_t v, std::optional<Point> towards);
  static void join(Stand& found, const Stand& next);
  std::optional<End> leave_sector(std::uint32_t sector, Stand& next);

  const Triangulation& tri_;
  Point p_, q_;
  bool bounded_;
  Stand stand_;
};

}  // namespace taut
