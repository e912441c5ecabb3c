// A comparison of planners as JSON.
#pragma once

#include <taut/io/results/json.h>
#include <taut/search/planners.h>

namespace taut {

/// One JSON object; keys are stable:
///  seed, runs, start, goal
///  optimum   the length of the shortest path in the plane, null when there is none
///  proven_none  true when walls prove that there is no path
///  within    where crossings of walls had to be rounded, and of a disc: no path that stays this far from obstacles is
///            shorter than the optimum, and proven_none is of such paths; also in the place of a planner's `optimal`
///  planners  [{name, roadmap, optimal, solved (0 .. 1, the part of the runs), length, ratio, clearance, points,
///            vertices, edges, graph_bytes (in memory), build_seconds, query_seconds (both CPU), expanded, verified,
///            all_runs: [{seed, solved, length, ...}] when there are several}]; of one that did not run {name, roadmap,
///            unfit: why}
Json comparison_json(const Comparison& comparison);

}  // namespace taut
