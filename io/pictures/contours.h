// Contour lines of the distance from a place: the potentials of a certificate, drawn.
#pragma once

#include <cstddef>
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut {

/// Pieces of lines on which all places are equally far from `from`, walls walked around: `count` lines evenly from 0 to
/// the farthest place. For pictures: distances are exact at the corners of a square grid of 200 steps on the longer
/// side of the world and linear in between; squares that a wall passes through are left out. Precondition: `from` is a
/// place for the robot, count > 0. Same input, same lines. O(1) searches.
std::vector<Segment> contours(const FreeSpace& space, Point from, std::size_t count);

}  // namespace taut
