// What grid searches found, as JSON.
#pragma once

#include <taut/io/results/json.h>
#include <taut/search/grid/grid_heuristics.h>
#include <taut/search/grid/grid_search.h>

namespace taut {

/// Does the algorithm ask a heuristic?
bool is_informed(GridAlgorithm algorithm);

/// `[row, column]`
Json grid_place_json(GridPlace place);

/// `algorithm`, `heuristic` (where one is asked), `moves`, `ties`, `steps`, `cost` (null unless found), with it
/// `straight`, `diagonal`, `optimal`; `cells`, `path` of [row, column].
Json grid_result_json(const GridResult& result, const GridQuery& query, GridMoves moves);

/// `heuristic`, `admissible`, `consistent`; of the witnesses against it `overestimate` {cell, h, cost} and `violation`
/// {from, to, h_from, h_to, cost}.
Json heuristic_json(const GridHeuristic& heuristic, const HeuristicVerdict& verdict);

}  // namespace taut
