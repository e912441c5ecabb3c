// The value surface of value iteration, drawn under a car's drive.
#pragma once

#include <string>

#include <taut/robots/car/value_iteration.h>

namespace taut::cli {

/// A layer for drive_svg: each point of the discretisation that has a value is coloured by the least value of its headings (light at the goal, dark far away), with an
/// arrow along that heading's best action; where no heading has a value nothing is drawn. And a legend with the scale, at the height `below` under the picture.
/// On discretisations finer than cells arrows stand on the cells' centres only.
struct ValueLayer {
  std::string surface;  ///< to be drawn before walls
  std::string arrows;   ///< after them
  std::string legend;
};
ValueLayer value_layer(const car::ValueGrid& grid, const car::Values& values, double legend_x, double legend_y);

}  // namespace taut::cli
