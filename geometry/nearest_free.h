// An end that is not free: what it stands in, and the nearest place for the robot.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <taut/geometry/free_space.h>

namespace taut {

/// A place where the robot can be.
struct FreePlace {
  Point point;
  double distance = 0;               ///< from what was asked about, to the nearest double
  double rounding = 0;               ///< no place is nearer than `distance - rounding`
  std::uint32_t constraint = kNone;  ///< that the place lies on, or that is nearest to it; kNone: p was free itself
};

/// The place of the space that is nearest to p; p itself when it is one. Nothing when there is no place at all.
///
///  1. `point` is free: the space locates it, on the outline of an obstacle or beside it, never inside.
///  2. Which piece is nearest is decided exactly; of equally near ones it is the first. Where p's foot on it is a pair
///     of decimals `rounding` is 0; else it is moved to the finest decimals beside it that are free, and `rounding` is
///     an upper bound of how far.
///  3. Of a disc the places are those of its polygon, as everywhere in the space; roadmaps/disc_places.h knows the
///     true ones.
/// O(n) for n constraints. Precondition: p's coordinates are 0 or of magnitude World::kSmallest to kLargest.
std::optional<FreePlace> nearest_free(const FreeSpace& space, Point p);

/// What stands nearest to a point.
struct NearObstacle {
  enum class Kind {
    none,     ///< the world is empty
    wall,     ///< a wall of the world
    solid,    ///< a solid polygon
    outline,  ///< of an area: beyond it one is outside
  };
  Kind kind = Kind::none;
  std::uint32_t index = kNone;  ///< into walls(), solids() or areas()
  Segment side{};               ///< the wall's centre line, or the nearest side
  double distance = 0;          ///< to within rounding; negative inside
  int line = 0;                 ///< of the file, where known
};

/// The wall, solid or outline that is nearest to p, or that p is deepest in; its thickness counts, no robot's size.
/// Outlines of floor plans count everywhere, those of other worlds only for a p outside. For messages: near ties are
/// broken by rounding, exact ones go to walls first, then to the lower index. O(n).
NearObstacle nearest_obstacle(const World& world, Point p);

/// Does p lie in one of the areas, or on the outline of one? Exact. O(n).
bool is_in_world(const World& world, Point p);

/// `the wall from (1, 2) to (4, 2), line 7`
std::string text(const NearObstacle& obstacle);

}  // namespace taut
