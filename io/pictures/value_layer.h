// The value surface of value iteration, drawn under a car's drive.
#pragma once

#include <string>
#include <vector>

#include <taut/robots/roadblocks/value_iteration.h>

namespace taut {

/// A layer for drive_svg, in cells: each point of the discretisation that has a value is coloured by the least value of
/// its headings (light at the goal, dark far away), with contour lines at round heights, every fifth stronger, and an
/// arrow along that heading's best action; where no heading has a value nothing is drawn. On discretisations finer than
/// cells arrows stand on the cells' centres only.
struct ValueLayer {
  std::string surface;               ///< to be drawn before walls
  std::string arrows;                ///< after them
  std::string scale;                 ///< what the colours mean
  std::vector<std::string> colours;  ///< from the least value to the greatest
};
ValueLayer value_layer(const roadblocks::ValueGrid& grid, const roadblocks::Values& values);

}  // namespace taut
