// How wide the ways through a free space are, all in all.
#pragma once

#include <taut/geometry/free_space.h>

namespace taut {

/// The mean width of the space between obstacles: twice the free area by the length of what bounds it (zero-thickness
/// walls count twice), at most an eighth of the box's longer side. In the world's unit. > 0. O(size of the free space).
double corridor_width(const FreeSpace& space);

}  // namespace taut
