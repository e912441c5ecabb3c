// A world without thickness, overlaps and footprints.
#pragma once

#include <taut/geometry/footprint.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/world.h>

namespace taut {

/// Does a point move there as `world` says, piece by piece: one area at most, no wall with a thickness, robot a point?
bool is_plain(const World& world, const Footprint& robot = Footprint::point());

/// A world in which a point moves as the robot does in `space`: its polygons, which do not overlap, are the areas, and
/// walls of no thickness stay walls. space.report().displacement is what rounding moved. Start and goal are kept.
/// Where the world is plain it is that world. Throws InputError as World does, where polygons touch in a way that rings
/// of a world may not.
World plain_world(const FreeSpace& space);

}  // namespace taut
