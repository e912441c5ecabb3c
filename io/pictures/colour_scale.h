// Numbers as colours.
#pragma once

#include <string>

namespace taut {

/// `#rrggbb` for 0 .. 1 (clamped), evenly in lightness and safe for the colour-blind: viridis without its palest end,
/// which is lost on white. For lines and cells on a page.
std::string shade_colour(double shade);

/// The same, dark blue to yellow: for a whole map that is filled.
std::string flood_colour(double shade);

}  // namespace taut
