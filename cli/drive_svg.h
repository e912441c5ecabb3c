// Pictures of a car's drive.
#pragma once

#include <string>

#include <taut/cli/drive_values.h>
#include <taut/robots/car/drive.h>

namespace taut::cli {

/// One SVG 1.1 document, rows down: walls, what the car came near enough to see (tint), roadblocks by state (open, closed, never seen), every
/// 8th pose as an outline, the centre's way (reversing in another colour), start, goal, the last pose. With `animate` the car drives along it, for
/// ever, by SMIL. Walls are squares or, in the reading of points, dots on tinted squares. Same input, same bytes.
/// With `values` their surface and arrows stand in the place of the tint.
std::string drive_svg(const car::Course& course, const car::Drive& drive, car::WallReading reading, bool animate,
                      const std::string& title, const ValueLayer* values = nullptr);

/// Where the legend of `values` belongs.
inline double legend_row(const car::Course& course) { return course.height + 3.2; }

}  // namespace taut::cli
