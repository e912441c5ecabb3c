// The ways that there are, in one picture.
#pragma once

#include <string>

#include <taut/geometry/free_space.h>
#include <taut/io/results/alternatives_json.h>
#include <taut/io/results/end_moves.h>

namespace taut {

/// svg() with each way in a colour of its own, the shortest the darkest and on top, its number beside it and in the key
/// with length and width; the gate that makes it narrow is drawn. No times. Same input, same bytes.
std::string alternatives_svg(const AlternativesAnswer& answer, const FreeSpace& space, const std::string& title,
                             const std::vector<EndMove>& moves = {});

}  // namespace taut
