// What room costs, as a picture: the ways in the world beside the length as it depends on the radius.
#pragma once

#include <string>

#include <taut/geometry/free_space.h>
#include <taut/io/results/end_moves.h>
#include <taut/io/results/tradeoff_json.h>

namespace taut {

/// svg_front() of the stretches; with `animate` a film: the disc grows, what it sweeps on its shortest way and how long
/// that is. A stretch of few radii is shown for a while, too. No times. Same input, same bytes. Precondition: there are
/// stretches.
std::string tradeoff_svg(const TradeoffAnswer& answer, const FreeSpace& space, const Gates& gates,
                         const std::string& title, const std::vector<EndMove>& moves = {}, bool animate = false);

}  // namespace taut
