// Points from files: places to go to, between which something is asked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/point.h>

namespace taut {

/// A point and the line that it stands in (in JSON: ends in).
struct ReadPoint {
  Point point;
  int line = 0;
};

/// Reads any number of points, in the file's order, repeated ones too:
///  - text: a point `x y` or `x,y` a line, `#` starts a comment;
///  - CSV below a heading that names its columns, of which `x` and `y` (or `lon` and `lat`, `longitude` and `latitude`)
///    are taken, in any order; other columns may hold anything but commas and quotes;
///  - JSON: a list of points `[[x, y], ...]`;
///  - GeoJSON: Point and MultiPoint, in features and collections; further numbers of a position are left out.
/// Throws InputError with the line; on GeoJSON of another type, too.
std::vector<ReadPoint> read_points(std::string_view bytes, const std::string& source = {});

}  // namespace taut
