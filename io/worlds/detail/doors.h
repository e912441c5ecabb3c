// Doors in walls.
#pragma once

#include <vector>

#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut::detail {

/// How far from the line of a wall a door's ends may lie.
struct Beside {
  double tolerance = 0;  ///< of all doors
  double rounding = 0;   ///< where a number of the two is computed
};

/// Takes away what the door covers of the walls that lie on its line, exactly or no farther from its ends than that:
/// these bend to end where the door does, and nothing as short as that stays of them. Of a thick wall so much more goes
/// that the caps of what is left do not reach into the door. False when it covers none. O(walls).
bool open_door(std::vector<Wall>& walls, const Segment& door, const Beside& beside = {});

}  // namespace taut::detail
