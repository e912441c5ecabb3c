// Pictures of a chase.
#pragma once

#include <string>

#include <taut/robots/pursuit/chase_run.h>

namespace taut::pursuit {

/// The map as an image (north up; costs as shades, obstacles grey, at most 1000 pixels a side), over it the ways of
/// robot and target as lines, with marks at the same round seconds on both. `moves`: two discs run along them as well,
/// over and over. Same input, same bytes.
std::string chase_svg(const ChaseMap& map, const ChaseRun& run, const std::string& title, bool moves);

}  // namespace taut::pursuit
