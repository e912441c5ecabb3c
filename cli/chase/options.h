// What the subcommands of taut chase have in common.
#pragma once

#include <optional>
#include <string>

#include <taut/cli/command_line.h>
#include <taut/cli/stop.h>
#include <taut/io/results/json.h>
#include <taut/robots/pursuit/chase_run.h>

namespace taut::cli {

/// The rules, the same for one chase and for many.
struct ChaseRuleOptions {
  pursuit::Clock clock = pursuit::Clock::zero;
  bool free_planning = false;
  std::optional<double> plan_seconds{};
  int weight = 3;              ///< of weighted
  std::optional<int> ahead{};  ///< of ahead

  pursuit::ChaseRequest request(const pursuit::NamedPursuer& pursuer) const;
};

/// --clock, --free-planning, --plan-seconds, --weight, --ahead, and --jobs, of exact: two threads unless it is given.
void add_chase_rule_options(CommandLine& app, ChaseRuleOptions& rules, Limits& limits);

/// A line for each planner, for --help.
void explain_chase_planners(CommandLine& app);

/// A file, or standard input for `-`.
pursuit::ChaseMap read_chase_file(const std::string& file);

/// chase_json with `peak_memory_bytes`. Throws std::logic_error when a plan or a step was wrong.
Json checked_json(const pursuit::ChaseMap& map, const pursuit::ChaseRun& run);

}  // namespace taut::cli
