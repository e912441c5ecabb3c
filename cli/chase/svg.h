// Pictures of a chase.
#pragma once

#include <string>

#include <taut/cli/chase/run.h>

namespace taut::cli {

/// The map as an image (north up; costs as shades, dark blue for obstacles, at most 1000 pixels a side), over it the
/// ways of robot and target as lines, with marks at the same round seconds on both. `moves`: instead of the marks two
/// discs that run, over and over (SMIL).
std::string chase_svg(const pursuit::ChaseMap& map, const ChaseRun& run, bool moves);

}  // namespace taut::cli
