// Lines between queries that change the world.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <taut/geometry/point.h>

namespace taut::cli {

/// `+wall x1 y1 x2 y2` adds a wall, `-wall x1 y1 x2 y2` takes the stretch between two points of walls away.
struct WallLine {
  bool adds = true;
  Segment wall;
};

/// Nothing for a line of another kind; `#` starts a comment. Throws InputError with `source` and `number`.
std::optional<WallLine> wall_line(std::string_view line, const std::string& source, int number);

}  // namespace taut::cli
