// A path that keeps a clearance but near its ends, as a picture.
#pragma once

#include <string>

#include <taut/geometry/free_space.h>
#include <taut/io/results/end_moves.h>
#include <taut/io/results/kept_json.h>

namespace taut {

/// svg() of the way with its arcs: the disc stands where each part begins and ends, as large as the part's; or there
/// are the walls and gates that leave no way. No times. Same input, same bytes.
std::string kept_svg(const KeptAnswer& answer, const FreeSpace& space, const std::string& title,
                     const std::vector<EndMove>& moves = {});

}  // namespace taut
