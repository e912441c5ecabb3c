#include <taut/cli/chase/options.h>
#include <taut/cli/command_line.h>

#include <taut/cli/options.h>
#include <taut/io/worlds/read_chase_map.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

using namespace pursuit;

namespace {

constexpr double kPlanSeconds = 0.9;  // the rules grant one; the rest is for what goes on around

Clock clock_of(const std::string& text) {
  if (text != "zero" && text != "one") throw UsageError("--clock: '" + text + "' is not zero or one");
  return text == "one" ? Clock::one : Clock::zero;
}

}  // namespace

ChaseRequest ChaseRuleOptions::request(const NamedPlanner* planner) const {
  return {planner, clock, free_planning, plan_seconds.value_or(free_planning ? 0 : kPlanSeconds), std::nullopt};
}

void add_chase_rule_options(CommandLine& app, ChaseRuleOptions& rules) {
  app.add_option_function(
         "--clock", [&rules](const std::string& text) { rules.clock = clock_of(text); },
         "The second of the target's first entry: zero (default) or one, the other scoring program's")
      .type_name("CLOCK")
      .group("Rules");
  app.add_flag("--free-planning", rules.free_planning, "Planning takes no time, however long it takes").group("Rules");
  app.add_option_function(
         "--plan-seconds",
         [&rules](const std::string& text) {
           rules.plan_seconds = number_of(text, "--plan-seconds");
           if (*rules.plan_seconds < 0) throw UsageError("--plan-seconds: '" + text + "' is below 0");
         },
         "Let exact, report and weighted plan for that long; exact then takes its best so far. 0: to the end (default: "
         "0.9, with --free-planning 0)")
      .type_name("S")
      .group("Rules");
}

ChaseMap read_chase_file(const std::string& file) {
  return read_chase_map(read_bytes(file), file == "-" ? "<stdin>" : file);
}

}  // namespace taut::cli
