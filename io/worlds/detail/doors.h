// Doors in walls.
#pragma once

#include <vector>

#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut::detail {

/// Takes away what the door covers of the walls that lie on its line (exactly); of a thick wall so much more that the
/// caps of what is left do not reach into the door. False when it covers none. O(walls).
bool open_door(std::vector<Wall>& walls, const Segment& door);

}  // namespace taut::detail
