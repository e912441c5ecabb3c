// taut solve --tradeoff: the shortest way of every disc, and the radii at which it changes.
#pragma once

#include <taut/cli/run.h>
#include <taut/cli/solve/solve_options.h>

namespace taut::cli {

/// A goal room stands for the middle of that of its boxes to which the largest disc gets. Every way is checked against
/// the walls at both ends of its stretch (verify_arcs). Preconditions: a tradeoff is asked for; a point robot.
int solve_tradeoff(const SolveOptions& options, Run& run);

}  // namespace taut::cli
