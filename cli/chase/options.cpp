#include <taut/cli/chase/options.h>

#include <sys/resource.h>

#include <stdexcept>

#include <taut/cli/jobs.h>
#include <taut/cli/options.h>
#include <taut/cli/world/foreign.h>
#include <taut/io/results/chase_json.h>
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

ChaseRequest ChaseRuleOptions::request(const NamedPursuer& pursuer) const {
  ChaseRequest request;
  request.planner = pursuer.planner;
  request.clock = clock;
  request.free_planning = free_planning;
  request.plan_seconds = plan_seconds.value_or(free_planning ? 0 : kPlanSeconds);
  request.ahead = pursuer.name == "ahead" && ahead ? ahead : pursuer.ahead;
  request.weight = static_cast<std::uint32_t>(weight);
  return request;
}

void add_chase_rule_options(CommandLine& app, ChaseRuleOptions& rules, Limits& limits) {
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
         "Let exact, entry and weighted plan for that long; exact then takes its best so far. 0: to the end (default: "
         "0.9, with --free-planning 0)")
      .type_name("S")
      .group("Rules");
  app.add_option("--weight", rules.weight, "How heavy the heuristic of weighted is, 1 to 1000 (default: 3)")
      .type_name("W")
      .range(1, 1000)
      .group("Rules");
  app.add_option("--ahead", rules.ahead, "How many seconds later ahead heads for the target's place (default: 20)")
      .type_name("S")
      .range(0, 1'000'000)
      .group("Rules");
  limits.jobs = 2;
  add_jobs_option(app, limits);
}

void explain_chase_planners(CommandLine& app) {
  std::vector<Choice> choices;
  for (const NamedPursuer& pursuer : chase_pursuers()) choices.emplace_back(pursuer.name, pursuer.description);
  app.explain("Planners", choices);
}

Json checked_json(const ChaseMap& map, const ChaseRun& run) {
  if (!run.fault.empty()) throw std::logic_error("the chase does not pass its own check: " + run.fault);
  Json json = chase_json(map, run);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  json["peak_memory_bytes"] = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  return json;
}

ChaseMap read_chase_file(const std::string& file) {
  const std::string bytes = read_bytes(file), source = source_name(file);
  return read_own(bytes, source, {FileKind::cost_map}, [&] { return read_chase_map(bytes, source); });
}

}  // namespace taut::cli
