// Which of many places are seen from one of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut::detail {

/// Places sorted into triangles, and what each sees of the others, by triangular expansion. One thread at a time.
///
/// Two places see each other when a view that is nowhere empty leads from one to the other: they may touch and run
/// along obstacles then. A line that grazes obstacles on both sides is not among them; it leads over a bend.
class SeenPlaces {
 public:
  /// Precondition: none is outside. Both outlive it.
  SeenPlaces(const FreeSpace& space, std::span<const Point> places);

  /// The places that place i sees, itself and those at the same point included; each once, in an order that depends on
  /// the space alone. Valid until the next call. O(triangles seen and places in them).
  const std::vector<std::uint32_t>& from(std::size_t i);

 private:
  struct View {
    std::uint32_t triangle;
    int side;
    Point right, left;
  };

  void sort_in();
  void add_triangles_of(std::size_t place);
  void add_triangle(std::uint32_t triangle) { triangles_.push_back(triangle); }
  void spread(Point origin, const View& first);
  void look_into(Point origin, const View& view, std::uint32_t triangle, int corner);
  void add(std::uint32_t place);

  Point point(std::uint32_t t, int i) const { return tri_.points[tri_.triangles[t][i]]; }

  const FreeSpace& space_;
  const Triangulation& tri_;
  std::span<const Point> places_;
  std::vector<std::size_t> first_triangle_;  // by place, into triangles_
  std::vector<std::uint32_t> triangles_;     // that hold a place, closed
  std::vector<std::uint32_t> first_place_;   // by triangle, into place_
  std::vector<std::uint32_t> place_;
  std::vector<std::uint32_t> marks_;  // by place: the last call that saw it
  std::uint32_t call_ = 0;
  std::vector<std::uint32_t> seen_;
  std::vector<View> open_;
};

}  // namespace taut::detail
