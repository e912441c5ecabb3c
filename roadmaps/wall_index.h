// What gates are made of: the constraints by vertex, which are walls, and where one may look.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/geometry/free_space.h>

namespace taut {

/// The constraints of a point robot's free space, seen as walls and openings.
class WallIndex {
 public:
  explicit WallIndex(const FreeSpace& space);

  const FreeSpace& space() const { return space_; }
  const Triangulation& triangulation() const { return space_.triangulation(); }
  Segment segment(std::uint32_t constraint) const;

  /// The vertices a and b of each constraint.
  const std::vector<std::array<std::uint32_t, 2>>& ends() const { return ends_; }
  bool is_opening(std::uint32_t constraint) const { return opening_[constraint]; }
  /// Does a wall end in the vertex?
  bool is_wall_vertex(std::uint32_t v) const { return wall_vertex_[v]; }
  /// The constraints that end in the vertex, ascending.
  std::span<const std::uint32_t> at(std::uint32_t v) const;
  /// The open triangles (below) that have the vertex, ascending.
  std::span<const std::uint32_t> around(std::uint32_t v) const;
  /// The constraint along side i of triangle t; kNone when there is none.
  std::uint32_t along(std::uint32_t t, int i) const;
  /// Is the triangle free, or reached from free ones without crossing a wall?
  bool is_open(std::uint32_t t) const { return open_[t]; }

  /// Calls visit(constraint) for the walls whose boxes meet `box`.
  template <class Visit>
  void walls_meeting(const Box& box, Visit&& visit) const {
    wall_boxes_.meeting(box, [&](std::uint32_t i) { visit(walls_[i]); });
  }

 private:
  void find_ends();
  void find_openings();
  void flood();
  void find_triangles();
  std::vector<Box> boxes_of_walls();

  FreeSpace space_;
  std::vector<std::array<std::uint32_t, 2>> ends_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> incident_;
  std::vector<std::uint32_t> first_triangle_;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint8_t> opening_;
  std::vector<std::uint8_t> wall_vertex_;
  std::vector<std::uint8_t> open_;
  std::vector<std::uint32_t> walls_;
  BoxIndex wall_boxes_;
};

}  // namespace taut
