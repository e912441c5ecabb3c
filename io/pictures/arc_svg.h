// A disc's way, as a picture.
#pragma once

#include <string>

#include <taut/geometry/free_space.h>
#include <taut/io/results/arc_json.h>
#include <taut/io/results/end_moves.h>

namespace taut {

/// svg() of the way with its true arcs; the disc stands at both ends and where it is pinched, or there are the walls
/// and gates that leave no way. `space` is a point's free space. No times. Same input, same bytes.
std::string arc_svg(const ArcAnswer& answer, const FreeSpace& space, const std::string& title,
                    const std::vector<EndMove>& moves = {});

}  // namespace taut
