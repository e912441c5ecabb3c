// taut chase compare: all planners on the same maps.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include <taut/cli/chase/options.h>
#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>

namespace taut::cli {

using namespace pursuit;

namespace {

struct ChaseCompareOptions {
  std::vector<std::string> files;
  ChaseRuleOptions rules;
  std::string json;
  CommonOptions common;
};

void add_compare_options(CommandLine& app, ChaseCompareOptions& options) {
  app.add_option("MAP", options.files, "Cost maps").required();
  add_chase_rule_options(app, options.rules);
  app.add_option("--json", options.json, "Write everything as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
}

std::string row(const ChaseMap& map, const ChaseRun& run) {
  const ChaseResult& r = run.result;
  return fmt::format("{:<20} {:<9} {:>6} {:>6} {:>6} {:>12} {:>7} {:>12} {:>12}\n", title_of(map.source()),
                     run.request.planner_name(), run.is_caught() ? "yes" : "no", r.time, r.moves, map.cost_text(r.cost),
                     run.is_proven(map) || run.is_hopeless() ? "yes" : "no", seconds_text(r.first_thought),
                     seconds_text(r.longest_thought));
}

int run_compare(const ChaseCompareOptions& options) {
  require_writable(options.json);
  std::string table = fmt::format("{:<20} {:<9} {:>6} {:>6} {:>6} {:>12} {:>7} {:>12} {:>12}\n", "map", "planner",
                                  "caught", "time", "moves", "cost", "proven", "first plan", "slowest");
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  int code = kFound;
  double ignored = 0;
  for (const std::string& file : options.files) {
    const ChaseMap map = timed("read", ignored, [&] { return read_chase_file(file); });
    int best = kInternal;
    for (const NamedPlanner& planner : chase_planners()) {
      const ChaseRun run = timed("chase", ignored, [&] { return run_chase(map, options.rules.request(&planner)); });
      table += row(map, run);
      if (!options.json.empty()) all.push_back(chase_json(map, run));
      if (!run.is_caught())
        note(fmt::format("taut: {}: {}: {}", title_of(file), run.request.planner_name(), run.why_not()));
      best = std::min(best, run.exit_code());
    }
    code = std::max(code, best);
  }
  finish();
  write_file(options.json, options.json.empty() ? "" : all.dump() + "\n");
  if (options.json != "-") print(table);
  return code;
}

}  // namespace

Command chase_compare_command(CommandLine& chase) {
  return command<ChaseCompareOptions>(chase, "compare", "Let all planners chase on the same maps", add_compare_options,
                                      run_compare);
}

}  // namespace taut::cli
