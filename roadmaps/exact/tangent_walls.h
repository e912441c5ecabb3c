// What stands in the way of a disc: legs and arcs against walls, openings and joints; and what a place sees.
#pragma once

#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/roadmaps/exact/tangent_circle.h>
#include <taut/roadmaps/exact/taut_cones.h>
#include <taut/roadmaps/wall_index.h>

namespace taut {

/// Around a centre: the directions that walls forbid, and where openings meet the circle.
struct CircleObstacles {
  /// A circle of radius r meets an opening, or the end of one.
  struct Crossing {
    SurdDirection at;
    std::uint32_t opening = kNone;  ///< met inside; or
    std::uint32_t vertex = kNone;   ///< in this vertex
  };
  std::vector<PlainDirection> forbidden;
  std::vector<Crossing> crossings;
};

class TangentWalls {
 public:
  explicit TangentWalls(const FreeSpace& space);

  const WallIndex& walls() const { return walls_; }
  const FreeSpace& space() const { return walls_.space(); }

  /// Can the centre follow the leg: no wall nearer than r, no opening crossed, no joint slipped through? An end at a
  /// vertex stays in its sector when one is named.
  bool is_free(const TangentLine& line, std::uint32_t from_sector, std::uint32_t to_sector) const;

  /// Calls visit(constraint) for the openings whose boxes meet `box`.
  template <class Visit>
  void openings_meeting(const Box& box, Visit&& visit) const {
    opening_boxes_.meeting(box, [&](std::uint32_t i) { visit(openings_[i]); });
  }

  CircleObstacles around(Point centre, double r) const;
  /// The same of openings alone.
  void add_crossings(Point centre, double r, CircleObstacles& obstacles) const;
  /// Can the centre follow the arc from a to b, counter-clockwise by at most 180 degrees? Precondition: a and b keep
  /// their distance, a != b.
  bool arc_is_free(const TangentPoint& a, const TangentPoint& b, const CircleObstacles& obstacles) const;

  /// The vertices that see a vertex or a place, by a straight line that crosses no wall (openings it may), ascending.
  /// With `cones` around a vertex, those alone that legs of its circle may lead to.
  std::vector<std::uint32_t> seen_from_vertex(std::uint32_t v, const TautCones& cones = {}) const;
  std::vector<std::uint32_t> seen_from(Point p) const;

  /// The nearest of the walls that are nearer to p than r; kNone when there is none. Exact.
  std::uint32_t too_near(Point p, double r) const;

 private:
  bool passes_vertex(const TangentLine& line, std::uint32_t v, std::uint32_t from_sector,
                     std::uint32_t to_sector) const;
  bool arc_passes_vertex(Point centre, std::uint32_t v, bool before, bool after) const;
  template <class Coordinates>
  std::vector<std::uint32_t> seen(const std::vector<std::array<std::uint32_t, 2>>& views,
                                  typename Coordinates::Place origin, Point at, const TautCones& cones) const;

  WallIndex walls_;
  Triangulation open_;  // openings do not hinder sight
  std::vector<std::uint32_t> openings_;
  BoxIndex opening_boxes_;
};

}  // namespace taut
