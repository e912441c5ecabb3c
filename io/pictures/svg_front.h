// The price of room: a step chart of length against the robot's radius, beside the maze.
#pragma once

#include <span>
#include <string>

#include <taut/io/pictures/svg.h>

namespace taut {

/// From the previous step's radius up to this one the best path is that long.
struct SvgStep {
  double radius = 0;
  double length = 0;
  std::string place{};  ///< where it is narrowest, for the list below the chart
};

/// One SVG 1.1 document: svg(space, picture) on the left, on the right the chart with a list of the steps (of many, the
/// first and last). Step i is drawn in the colour of picture.shades[i].
/// Precondition: as many steps as shades, at least one, radius and length ascending. Same input, same bytes.
std::string svg_front(const FreeSpace& space, const SvgPicture& picture, std::span<const SvgStep> steps);

}  // namespace taut
