// taut batch --widest and --arcs: discs of any radius on one world.
#pragma once

#include <taut/cli/run.h>
#include <taut/cli/solve/batch_options.h>

namespace taut::cli {

/// Throws UsageError where an option does not go with discs.
void require_disc_options(const BatchOptions& options);

int answer_disc_queries(const BatchOptions& options, Run& run);

}  // namespace taut::cli
