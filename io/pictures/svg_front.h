// The price of room: a step chart of length against the robot's radius, beside the maze.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <taut/io/pictures/svg.h>

namespace taut {

/// From the previous step's radius up to this one the best path is that long.
struct SvgStep {
  double radius = 0;
  double length = 0;
  std::string place{};  ///< where it is narrowest, for the list below the chart
  /// (radius, length) from one end to the other, where the length is not the same all along; ends at `radius`, `length`
  std::vector<Point> curve{};
};

/// The robot as it grows.
struct SvgFilm {
  struct Moment {
    double radius = 0;
    double length = 0;
    std::vector<Bezier> curves{};
  };
  double seconds = 0;
  std::vector<Moment> moments{};
};

struct SvgFrontWords {
  std::string length = "length of its best path along the diagram";
  std::string place = "narrowest";
  SvgFilm film{};  ///< nothing moves where it has no moments
};

/// One SVG 1.1 document: svg(space, picture) on the left, on the right the chart with a list of the steps (of many, the
/// first and last). Step i is drawn in the colour of picture.shades[i]. In a film what the robot sweeps moves over the
/// picture, and a dot over the chart; the ways stand still.
/// Precondition: as many steps as shades, at least one, radius and length ascending. Same input, same bytes.
std::string svg_front(const FreeSpace& space, const SvgPicture& picture, std::span<const SvgStep> steps,
                      const SvgFrontWords& words = {});

}  // namespace taut
