// taut solve --alternatives: the ways that there are.
#pragma once

#include <taut/cli/run.h>
#include <taut/cli/solve/solve_options.h>

namespace taut::cli {

/// Precondition: options.ways_given(). Throws InputError when an end is missing, is no point or no free place.
int solve_alternatives(const SolveOptions& options, Run& run);

}  // namespace taut::cli
