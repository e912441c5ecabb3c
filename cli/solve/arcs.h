// taut solve --arcs: the shortest path of a true disc.
#pragma once

#include <taut/cli/run.h>
#include <taut/cli/solve/solve_options.h>

namespace taut::cli {

/// Precondition: the robot is a disc. Throws InputError when an end is missing, is no point or no place for the disc.
int solve_with_arcs(const SolveOptions& options, Run& run);

}  // namespace taut::cli
