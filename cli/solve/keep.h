// taut solve --keep: the shortest path that keeps a clearance where its ends allow.
#pragma once

#include <taut/cli/run.h>
#include <taut/cli/solve/solve_options.h>

namespace taut::cli {

/// Precondition: options.keep > 0. Throws InputError when an end is missing, is no point or no free place.
int solve_keeping(const SolveOptions& options, Run& run);

}  // namespace taut::cli
