// Planners side by side on one page.
#pragma once

#include <string>

#include <taut/geometry/free_space.h>
#include <taut/io/results/end_moves.h>
#include <taut/search/planners.h>

namespace taut {

/// One SVG 1.1 document of 1000 pixels' width: a panel for each planner that ran, with its roadmap, its path and its
/// numbers in letters of 15 pixels; one legend. `title` heads it.
///
///  1. The world is written once and used by every panel (ids `taut-ground`, `taut-walls`, `taut-roadmap-N`: two such
///     pages within one HTML page must be of the same comparison). So is a roadmap that several planners share.
///  2. A roadmap of more than 6000 edges is left out, and its panel says so. Milestones are dots.
///  3. No times. Same input, same bytes.
std::string comparison_svg(const Comparison& comparison, const FreeSpace& space, const std::string& title,
                           const std::vector<EndMove>& moves = {});

}  // namespace taut
