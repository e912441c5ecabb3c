// The options of probabilistic roadmaps: --sampler, --connection, --prm-clearance, --samples, --lazy.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include <taut/cli/command_line.h>
#include <taut/search/prm_planner.h>

namespace taut::cli {

struct RoadmapKind;

/// What was asked for; what was not is up to the kind of roadmap.
struct PrmRequest {
  std::optional<PrmSampler> sampler{};
  std::optional<PrmConnection> connection{};
  std::optional<double> clearance{};
  std::optional<std::size_t> samples{};
  bool lazy = false;
  bool eager = false;

  /// The first option given, for messages; empty when there is none.
  std::string first() const;
};

/// Adds them in a group of their own; --lazy and --eager only where there is a query to be lazy for.
void add_prm_options(CommandLine& app, PrmRequest& request, bool with_query);

/// Throws UsageError when options were given that a roadmap of this kind cannot heed.
void require_prm_options_fit(const PrmRequest& request, const RoadmapKind& kind);

/// The plan of the request, with the sampler and connection that the kind has when nothing else was asked for. Without
/// --samples and --max-seconds it gives up after a minute.
PrmPlan plan_of(const PrmRequest& request, PrmSampler sampler, std::uint64_t seed, bool is_limited);

/// Shows how far growth has come, in one line on stderr when that is a terminal (progress), from a third of a second
/// on.
std::function<bool(const PrmProgress&)> prm_progress(bool quiet);

/// `1200 samples, 1180 vertices, 4000 edges of 9000 tested, 3 components, 700 vertices at the start, 12 at the goal`
std::string connectivity_text(const PrmConnectivity& connectivity);

}  // namespace taut::cli
