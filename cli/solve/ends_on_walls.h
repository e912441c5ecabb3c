// Ends of queries on walls, where crossings or the ends themselves were rounded.
#pragma once

#include <span>

#include <taut/cli/input.h>
#include <taut/cli/options.h>
#include <taut/cli/world/geographic.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/written_places.h>

namespace taut::cli {

/// Which ends a space made without knowing them may have off the wall that they lie on, and a space that has them
/// there. All that it is made of must outlive it.
class EndsOnWalls {
 public:
  EndsOnWalls(const Input& input, const Snap& snap, const FreeSpace& space);

  /// Does p (of the plane) lie on a sloped wall that bends nearby, or beside a wall within rounding, with a computed
  /// number among theirs?
  bool concern(Point p) const;
  /// The space of the same robot that has these ends where they are; of --project in longitude and latitude.
  FreeSpace space_with(std::span<const Point> given) const;

 private:
  bool is_beside_a_wall(Point p) const;

  const Input& input_;
  const Snap& snap_;
  const FreeSpace& space_;
  Shown shown_;
  WrittenPlaces places_;
  double rounding_;
};

}  // namespace taut::cli
