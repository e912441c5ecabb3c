// The way of somebody who moves, with times.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <taut/robots/fleet/fleet.h>

namespace taut {

/// A place of a way and the line that it stands in.
struct ReadTimedPoint {
  fleet::TimedPoint point;
  int line = 0;
};

/// Lines `t x y`, separated by blanks or commas, perhaps below a heading `t,x,y`; `#` starts a comment. Times ascend
/// strictly; there is one at least. Throws InputError with the line.
std::vector<ReadTimedPoint> read_timed_way(std::string_view bytes, const std::string& source = {});

}  // namespace taut
