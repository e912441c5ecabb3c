// taut solve --clearance, --widest and --tradeoff: paths along the Voronoi diagram that keep away from the walls.
#pragma once

#include <taut/cli/command_line.h>
#include <taut/cli/options.h>

namespace taut::cli {

/// What is asked about clearance, if anything.
struct ClearanceQuery {
  enum class Kind { none, at_least, widest, tradeoff };
  Kind kind = Kind::none;
  double clearance = 0;  ///< Kind::at_least
};

/// --clearance C, --widest, --tradeoff; at most one of them (UsageError).
void add_clearance_options(CommandLine& app, ClearanceQuery& query);

struct ClearanceRequest {
  const WorldOptions& world;
  const QueryOptions& query;
  const OutputOptions& output;
  ClearanceQuery what;
  bool verify = true;
  bool path = false;  ///< print its points
};

/// Throws UsageError where the other options do not suit it: only a point robot, and no path of a tradeoff to
/// print.
void require_suitable(const ClearanceRequest& request);

/// Gives the exit code. What bounds the world counts as a wall (walled_world). A goal room stands for the middle of
/// that of its boxes to which the largest disc gets. Every answer is checked against the gates (disc_passage), which
/// know nothing of the diagram; should they differ by its rounding, the answer is `stopped`.
int solve_with_clearance(const ClearanceRequest& request);

}  // namespace taut::cli
