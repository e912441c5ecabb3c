// What moves in a picture, again and again (SMIL).
#pragma once

#include <string>

#include <taut/io/pictures/detail/svg_path.h>

namespace taut::detail {

/// For an element of opacity 0: it is to be seen from one moment to another, both parts of the `seconds` that a round
/// takes.
std::string shown_between(double from, double until, double seconds);

/// A dot that runs along the line in that time; the radius in pixels.
std::string runner_along(const SvgPath& line, double radius, double seconds);

}  // namespace taut::detail
