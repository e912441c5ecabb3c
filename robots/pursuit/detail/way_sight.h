// Which parts of a segment are seen from a place.
#pragma once

#include <utility>
#include <vector>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/triangulation.h>

namespace taut::pursuit::detail {

/// A cone from a place between two vertices up to a side of a triangle; all that is free in it before the side is seen.
struct SightCone {
  Point right, left;
  Segment side;  ///< the place is to its left
};

/// From and to which part of a segment, 0 to 1.
using Part = std::pair<Rational, Rational>;

/// All that is seen from a free place, or from a vertex out of one of its sectors.
class WaySight {
 public:
  WaySight(const FreeSpace& space, Point from);
  WaySight(const FreeSpace& space, const Triangulation::Sector& sector);

  /// The parts of a segment that are seen, exactly, one for each cone (they meet at their ends, and some are points).
  std::vector<Part> parts(const Segment& s) const;

 private:
  Point from_;
  std::vector<SightCone> cones_;
};

}  // namespace taut::pursuit::detail
