// Polygons cut into triangles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/point.h>

namespace taut::detail {

struct PolygonTriangles {
  std::vector<std::array<Point, 3>> triangles;  ///< counter-clockwise
  double displacement = 0;                      ///< what rounding crossings of overlapping polygons moved at most
};

/// Triangles that tile the union of `polygons` (rings oriented as World does), which may touch and overlap.
/// Crossings are rounded as by node().
PolygonTriangles inside_triangles(std::span<const Polygon* const> polygons, const DecimalUnit& unit,
                                  std::span<const Point> fixed);

/// Triangles that tile the rest of the box `frame`, which contains the polygons in its interior. Crossings of
/// overlapping polygons are rounded into the polygons: what is outside stays so.
PolygonTriangles outside_triangles(std::span<const Polygon* const> polygons, const Box& frame, const DecimalUnit& unit,
                                   std::span<const Point> fixed);

}  // namespace taut::detail
