// What rounding leaves to be proven.
#pragma once

#include <taut/geometry/free_space.h>

namespace taut {

/// How far an obstacle of the space may lie from where it is written: rounded crossings bend walls, each of at most 34
/// roundings one on another by FreeSpaceReport::displacement. 0: nothing was rounded, the space is what is written.
///
/// A robot that stays farther than that from what is written meets nothing in the space, so of d = rounding_bound:
///  - a path that is the shortest in the space is no longer than any that stays farther than d from obstacles, and goes
///    through none deeper than d (`within: d`);
///  - where the space holds no path, none stays farther than d from obstacles, but at its ends (is_sure).
double rounding_bound(const FreeSpace& space);

/// How far the space may be from where the robot itself can be as written: rounding_bound, and of a disc, which the
/// space holds as a polygon around it, what that stands out (Footprint::kDiscExcess of its radius). What holds of a
/// path for rounding_bound holds of the robot's path for this.
double path_bound(const FreeSpace& space);

/// Is p on the side of everything near it that it is on as written? So when nothing was rounded; else when no obstacle
/// lies within twice rounding_bound of p but those that p lies on exactly, and of a point robot those that are where
/// they are written: pieces of walls and sides that no rounding bent. O(n), and O(n) more for each that near.
bool is_sure(const FreeSpace& space, Point p);

}  // namespace taut
