#include <taut/cli/solve/ends_on_walls.h>

#include <algorithm>
#include <vector>

#include <taut/geometry/snap.h>
#include <taut/geometry/written.h>

namespace taut::cli {

EndsOnWalls::EndsOnWalls(const Input& input, const Snap& snap, const FreeSpace& space)
    : input_(input),
      snap_(snap),
      space_(space),
      shown_(input.notes),
      places_(space),
      rounding_(rounding_tolerance(input.world.parts())) {
  if (shown_) rounding_ = std::max(rounding_, 2 * input.world.uncertainty());
}

bool EndsOnWalls::concern(Point p) const { return places_.is_moved(p) || is_beside_a_wall(p); }

/// Then snapped() puts it on the wall.
bool EndsOnWalls::is_beside_a_wall(Point p) const {
  const bool written = written::decimal(p.x) && written::decimal(p.y) && space_.world().uncertainty() == 0;
  if (written || snap_.what == Snap::What::nothing) return false;
  if (space_.footprint().kind() != Footprint::Kind::point) return false;
  if (space_.locate(p).kind == Location::Kind::outside) return true;
  const double distance = space_.clearance(p).distance;
  return distance > 0 && distance <= rounding_;
}

FreeSpace EndsOnWalls::space_with(std::span<const Point> given) const {
  std::vector<Point> ends(given.begin(), given.end());
  if (shown_) {
    for (Point& p : ends) p = shown_.geographic()->metres(p);
    return FreeSpace(snapped_world(shown_.geographic()->in_metres(given), snap_, ends).world, space_.footprint(), ends);
  }
  const bool joins = snap_.what != Snap::What::nothing;
  return FreeSpace(joins ? snapped(input_.world, Snap{}, ends).world : input_.world, space_.footprint(), ends);
}

}  // namespace taut::cli
