// Plans of many robots with times.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <taut/robots/fleet/fleet.h>

namespace taut {

/// Is it text whose first line is a heading `id,t,x,y` or has an id and three numbers or more?
bool holds_fleet(std::string_view bytes);

/// Lines `id t x y` or `id t x y r`, separated by blanks or commas, perhaps below a heading `id,t,x,y`; `#` starts a
/// comment. Lines of different robots may be mixed; those of one come in the order of time. r is the robot's radius,
/// said once or the same again; `radius` is that of robots that say none. In the order in which they appear. Throws
/// InputError with the line.
std::vector<fleet::Robot> read_fleet(std::string_view bytes, std::optional<double> radius,
                                     const std::string& source = {});

}  // namespace taut
