// Paths from files, for those who want one checked.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/point.h>

namespace taut {

/// A path somebody claims.
struct ClaimedPath {
  std::vector<Point> points;
  std::optional<double> length;  ///< what the file says it measures
};

/// Reads a path: JSON, either a list of points `[[x, y], ...]` or an object with such a list under "points" and
/// perhaps a number under "length", by itself or as the "result" of an envelope (what `taut solve --json` writes); or
/// text, a point `x y` or `x,y` a line, `#` starts a comment. Any number of points.
/// Throws InputError with the line; on a JSON result without points (its status is not "found") too.
ClaimedPath read_path(std::string_view bytes, const std::string& source = {});

}  // namespace taut
