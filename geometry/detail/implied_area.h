// The boundary of a world whose input gives none. Private: World guarantee 3.
#pragma once

#include <algorithm>
#include <limits>

#include <taut/geometry/world.h>

namespace taut::detail {

/// An axis-parallel box that grows.
class Bounds {
 public:
  void add(Point p) {
    box_.min = {std::min(box_.min.x, p.x), std::min(box_.min.y, p.y)};
    box_.max = {std::max(box_.max.x, p.x), std::max(box_.max.y, p.y)};
  }
  void add(Point p, double margin) {
    add({p.x - margin, p.y - margin});
    add({p.x + margin, p.y + margin});
  }
  bool empty() const { return box_.min.x > box_.max.x; }
  const Box& box() const { return box_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box_{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
};

/// Gives `parts` the one area of World guarantee 3 and the kind of boundary that it is. O(n log n).
void imply_area(WorldParts& parts);

/// The same for a Boundary::open that stays one, after ends or thicknesses changed.
void widen_area(WorldParts& parts);

/// Does an end, or a part of a room, lie beyond the one area? Exact.
bool ends_beyond(const WorldParts& parts);

/// The rings that could be the outer face of the walls when they are not axis-parallel: rectangles with a side along
/// the convex hull, then the hull itself if it has at most 64 corners. A side passes through those of `points` that are
/// no farther from it than `reach`, so what lies on it but for rounding lies on it.
struct TurnedFaces {
  std::vector<Ring> rectangles;
  Ring hull;
};
TurnedFaces turned_faces(const std::vector<Wall>& walls, const std::vector<Point>& points, double reach);

/// The ring with its sides passing through the points within reach, in order.
Ring passed_through(const Ring& ring, const std::vector<Point>& points, double reach);

}  // namespace taut::detail
