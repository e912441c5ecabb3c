// Pictures of a general car's drive.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/geometry/world.h>
#include <taut/robots/car/leg.h>

namespace taut {

struct CarPicture {
  std::string title;
  std::vector<std::string> facts;
  std::vector<car::Leg> legs;
  std::optional<car::LatticePose> start_pose;
  Point start;
  std::vector<Point> goals;
  std::vector<Segment> barrier;  ///< what stands in the way
  bool animate = false;
};

/// One SVG 1.1 document, 960 pixels on the longer side: the world, the area the car sweeps over (the union of many
/// outlines: a picture, not a proof), some outlines, the rear axle's way (reversing in another colour), start, goals,
/// the car at the end. With `animate` it drives along, for ever, by SMIL. Same input, same bytes.
std::string car_svg(const World& world, const car::CarShape& shape, const CarPicture& picture);

}  // namespace taut
