// Paths that keep away from walls, and what stops a disc, as pictures. No times in them. Same input, same bytes.
#pragma once

#include <string>

#include <taut/io/results/end_moves.h>
#include <taut/search/clearance_planner.h>
#include <taut/search/passage.h>
#include <taut/search/passage_index.h>

namespace taut {

/// svg() with the path and its pinch; a tradeoff beside its step chart. `space` is a point's free space; `map` is drawn
/// below the path when there is one.
std::string clearance_svg(const ClearanceAnswer& answer, const FreeSpace& space, const VoronoiRoadmap& map,
                          const std::string& title, const std::vector<EndMove>& moves = {});

/// svg() with the walls and gates that stop the disc, or any larger one.
std::string passage_svg(const Passage& passage, const FreeSpace& space, const std::string& title,
                        const std::vector<EndMove>& moves = {});

/// svg() with the faces of passage_map, each in the colour of the largest disc that gets into it.
std::string passage_map_svg(const PassageIndex& index, Point start, const std::string& title,
                            const std::vector<EndMove>& moves = {});

}  // namespace taut
