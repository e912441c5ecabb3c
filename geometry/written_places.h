// Points that lie on a wall as written, but beside it once crossings are rounded.
#pragma once

#include <memory>

#include <taut/geometry/free_space.h>

namespace taut {

/// Of a free space of a point robot: was a query's end moved off what it lies on? Walls and sides bend where
/// crossings are rounded; only points that the FreeSpace knew when it was built are sure to stay on them. Who asks
/// about others builds one for them: FreeSpace(world, footprint, ends).
class WrittenPlaces {
 public:
  explicit WrittenPlaces(const FreeSpace& space);

  /// Does p lie on a wall or side as written, and on no constraint? False when nothing was rounded. O(log n).
  bool is_moved(Point p) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace taut
