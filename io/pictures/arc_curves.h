// Legs and arcs as the curves that pictures draw.
#pragma once

#include <vector>

#include <taut/roadmaps/bezier.h>
#include <taut/search/arc_path.h>

namespace taut {

/// Chained curves along the pieces, no farther from an arc than 2e-6 of its radius.
std::vector<Bezier> arc_curves(const std::vector<ArcPiece>& pieces);

}  // namespace taut
