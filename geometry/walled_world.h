// A world whose limits are walls.
#pragma once

#include <vector>

#include <taut/geometry/world.h>

namespace taut {

/// A world in which its limits are walls, so that a disc stays inside whole; but where one of the `ends` stands on an
/// opening that is parallel to an axis, the opening is a door into a dead end as deep as it is wide.
World walled_world(const World& world, const std::vector<Point>& ends);

}  // namespace taut
