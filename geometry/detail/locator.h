// Which triangle contains a point.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut::detail {

/// A grid of hints over a triangulation: a visibility walk starts at the triangle of the point's cell. Exact. Expected
/// O(1) on evenly spread triangles; O(n) at worst. Memory: 4 bytes a cell, about one cell for two triangles.
class Locator {
 public:
  Locator() = default;
  explicit Locator(const Triangulation& tri);

  Location locate(const Triangulation& tri, Point p) const;

 private:
  std::uint32_t cell(Point p) const;
  std::uint32_t walk(const Triangulation& tri, Point p) const;

  Box box_;
  double per_x_ = 0, per_y_ = 0;
  std::uint32_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> hints_;
};

}  // namespace taut::detail
