// Pictures of a car's drive.
#pragma once

#include <string>
#include <vector>

#include <taut/io/pictures/value_layer.h>
#include <taut/robots/roadblocks/drive.h>
#include <taut/robots/roadblocks/tree_planner.h>

namespace taut {

struct DrivePicture {
  std::string title;
  std::vector<std::string> facts;
  roadblocks::WallReading reading = roadblocks::WallReading::points;
  bool animate = false;
  const ValueLayer* values = nullptr;          ///< in the place of the tint of what was in sight
  std::vector<roadblocks::TreeBranch> tree{};  ///< thin lines below the way
};

/// One SVG 1.1 document, rows down: walls, what the car came near enough to see (tint), roadblocks by state (open,
/// closed, never seen), every 8th pose as an outline, the centre's way (reversing in another colour), start, goal, the
/// last pose. With `animate` the car drives along it, for ever, by SMIL. Walls are squares or, in the reading of
/// points, dots on tinted squares. Same input, same bytes.
std::string drive_svg(const roadblocks::Course& course, const roadblocks::Drive& drive, const DrivePicture& picture);

}  // namespace taut
