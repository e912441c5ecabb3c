// What the subcommands of taut chase have in common.
#pragma once

#include <optional>
#include <string>

#include <taut/cli/chase/run.h>
#include <taut/cli/command_line.h>

namespace taut::cli {

/// The rules, the same for one chase and for many.
struct ChaseRuleOptions {
  pursuit::Clock clock = pursuit::Clock::zero;
  bool free_planning = false;
  std::optional<double> plan_seconds{};

  ChaseRequest request(const pursuit::NamedPlanner* planner) const;
};

/// --clock, --free-planning, --plan-seconds.
void add_chase_rule_options(CommandLine& app, ChaseRuleOptions& rules);

/// A file, or standard input for `-`.
pursuit::ChaseMap read_chase_file(const std::string& file);

}  // namespace taut::cli
