// Where the centre of a disc can be, by its true distance from walls.
#pragma once

#include <memory>
#include <optional>

#include <taut/geometry/nearest_free.h>

namespace taut {

/// The places of a disc: what a point can reach of the world, less what is nearer than r to a wall.
///
///  1. Walls and openings are those of Gates, guarantee 1: the centre keeps its distance from walls, not from openings,
///     which it may touch. r is what the number means, not a polygon around it.
///  2. is_free is exact.
///  3. nearest(p) is free, exactly: p itself when it is; nothing when no place was found. `constraint` is the wall or
///     opening nearest to it. `rounding` bounds how much nearer another place can be: the place is where p's foot on
///     the outline of the places lies (on a line beside a wall, a circle around its end, or where two of these cross),
///     known to 60 digits and moved to the finest decimals beside it that are free. Places that no double holds, as in
///     a sloped gap exactly 2r wide, count for `rounding` only.
/// Method: squares around p, the nearer first, cut in four until few walls concern one or a wall covers it.
/// Built in O(n log n); nearest() looks at all walls once, then at those near p.
/// Preconditions: the space's footprint is Footprint::point(); 0 < r <= World::kLargest.
class DiscPlaces {
 public:
  DiscPlaces(const FreeSpace& space, double r);

  const FreeSpace& space() const;
  double radius() const;

  bool is_free(Point p) const;
  std::optional<FreePlace> nearest(Point p) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace taut
