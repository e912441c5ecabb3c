// Roadblocks that stand or fall together: in series in one lane they are one door.
#pragma once

#include <vector>

#include <taut/robots/roadblocks/drive.h>

namespace taut::roadblocks {

/// Where a car comes to a door from one side.
struct DoorSide {
  Point look;                  ///< between the door and where it first shows: a car that covers this point sees it
  std::vector<Point> arrival;  ///< the car's centre about where the door first shows; at least one
};

struct Door {
  RoadblockSet blocks = 0;      ///< all open: the door is open; one closed: it is closed
  double open_probability = 1;  ///< the product of theirs
  std::vector<DoorSide> sides;  ///< where it parts nothing there are less than two
};

/// The doors of a course, by their first roadblocks; every roadblock is in exactly one.
///
///  1. Judged by a disc of radius kHalfWidth on a raster of 1/4, all roadblocks being closed: what the disc cannot be
///     on because of roadblocks are their zones, the rest falls into regions. A pocket is a region that borders two
///     roadblocks only, lies in sight of both and holds neither start nor goal: nobody has business there.
///  2. A side is a piece of a region, within kSight of roadblocks, that touches their zone; pockets have none.
///  3. Two roadblocks are in series when a pocket lies between them, or when their zones touch and neither joins two of
///     its sides by being open alone (two side by side in a wide lane do: they are two doors). Only a door with two
///     sides or more is worth opening; a roadblock that stands free in a room has one.
///  4. As sets, the doors do not depend on the order of the roadblocks.
/// O(cells of the raster * roadblocks).
std::vector<Door> doors(const Course& course, WallReading reading);

}  // namespace taut::roadblocks
