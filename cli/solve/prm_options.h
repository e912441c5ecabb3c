// The options of probabilistic roadmaps: --sampler, --connection, --prm-clearance, --samples, --lazy.
#pragma once

#include <string>

#include <taut/cli/command_line.h>
#include <taut/search/roadmap_kinds.h>

namespace taut::cli {

/// Adds them in a group of their own; --lazy and --eager only where there is a query to be lazy for.
void add_prm_options(CommandLine& app, PrmRequest& request, bool with_query);

/// The first of these options that was given, for messages; empty when there is none.
std::string first_option(const PrmRequest& request);

/// Throws UsageError when options were given that a roadmap of this kind cannot heed.
void require_prm_options_fit(const PrmRequest& request, const RoadmapKind& kind);

/// `1200 samples, 1180 vertices, 4000 edges of 9000 tested, 3 components, 700 vertices at the start, 12 at the goal`
std::string connectivity_text(const PrmConnectivity& connectivity);

}  // namespace taut::cli
