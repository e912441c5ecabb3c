// taut solve --clearance and --widest: paths along the Voronoi diagram that keep away from the walls.
#pragma once

#include <taut/cli/run.h>
#include <taut/cli/solve/solve_options.h>

namespace taut::cli {

/// What bounds the world counts as a wall (walled_world). A goal room stands for the middle of that of its boxes to
/// which the largest disc gets. Every answer is checked against the gates (disc_passage), which know nothing of the
/// diagram; should they differ by its rounding, the answer is `unproven`. Precondition: options.clearance, no tradeoff.
int solve_with_clearance(const SolveOptions& options, Run& run);

}  // namespace taut::cli
