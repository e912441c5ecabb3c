// A comparison as a table, as JSON, as pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <taut/cli/solve/planners.h>
#include <taut/geometry/free_space.h>

namespace taut::cli {

struct Comparison {
  std::string source;
  Point start;
  Goal goal;
  std::uint64_t seed = 1;
  std::size_t runs = 1;
  std::vector<PlannerRuns> planners{};
  std::optional<Length> optimum{};  ///< of the plane; absent when no path was found
  bool is_shut = false;             ///< walls prove that there is none

  /// The first planner of which a path does not pass the check; nullptr when all do.
  const PlannerRuns* wrong() const;
};

/// One line a planner, columns aligned: solved (`yes`, `no`, of several runs `18/20`), length, ratio to the optimum
/// (`1` only when the lengths are exactly equal), least clearance, vertices, edges, build and query seconds,
/// expansions, verified. Of several runs medians; lengths and clearances are those of the typical run. Planners that
/// did not run are left out.
std::string comparison_table(const Comparison& comparison);

/// One JSON object; keys are stable:
///  program, source, seed, runs
///  optimum   the length of the shortest path in the plane, null when there is none
///  proven_none  true when walls prove that there is no path
///  planners  [{name, roadmap, optimal, solved (0 .. 1, the part of the runs), length, ratio, clearance, points,
///            vertices, edges, build_seconds, query_seconds, expanded, verified, all_runs: [{seed, solved, length,
///            ...}] when there are several}]; of one that did not run {name, roadmap, unfit: why}
std::string comparison_json(const Comparison& comparison);

/// Small multiples: each planner's roadmap and path, with its numbers; roadmaps of more than 20 000 edges are left out.
std::string comparison_svg(const Comparison& comparison, const FreeSpace& space);

}  // namespace taut::cli
