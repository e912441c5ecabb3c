// taut grid scen: a MovingAI scenario file, every optimal length checked.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/grid/grid.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/geometry/errors.h>
#include <taut/io/results/detail/result_values.h>
#include <taut/io/worlds/movingai.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

namespace {

using nlohmann::ordered_json;

struct ScenarioOptions {
  std::string map;
  std::string scenarios;
  CommonOptions common;
  GridAlgorithm algorithm = GridAlgorithm::jps;
  std::string json;
};

void add_options(CommandLine& app, ScenarioOptions& options) {
  app.add_option("MAP", options.map, "A MovingAI map; - is standard input").required();
  app.add_option("SCEN", options.scenarios, "Its scenarios (version 1)").required();
  app.add_option_function(
         "--algorithm", [&options](const std::string& text) { options.algorithm = grid_algorithm_of(text); },
         "One that finds the least cost: jps (default), astar, dijkstra, bidirectional-astar, idastar")
      .type_name("NAME")
      .group("Search");
  app.add_option("--json", options.json, "Write the totals and mismatches as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.callback([&options] {
    if (!finds_least_cost({options.algorithm, natural_heuristic(GridMoves::octile)}, GridMoves::octile))
      throw UsageError(fmt::format("{} does not find the least cost", name(options.algorithm)));
    if (options.map == "-" && options.scenarios == "-")
      throw UsageError("MAP and SCEN cannot both come from standard input");
  });
}

/// Is this what the file says, as far as its digits go? Half a unit of the last one, and what doubles round.
bool agrees(double cost, const Scenario& scenario) {
  return std::abs(cost - scenario.optimal) <= 0.5 * scenario.unit() + 1e-12 * cost;
}

struct Totals {
  std::size_t matched = 0, missed = 0, shorter = 0, steps = 0;
  double cost = 0;
  double seconds = 0;
};

int run(const ScenarioOptions& options) {
  require_writable(options.json);
  const std::string map_name = options.map == "-" ? "<stdin>" : options.map;
  const std::string scen_name = options.scenarios == "-" ? "<stdin>" : options.scenarios;
  begin_stage("read");
  const OccupancyGrid grid = read_movingai_map(read_bytes(options.map), map_name);
  const std::vector<Scenario> scenarios = read_movingai_scenarios(read_bytes(options.scenarios), scen_name);
  begin_stage("search");
  GridSearch search(grid, GridMoves::octile);
  const GridQuery query{options.algorithm, natural_heuristic(GridMoves::octile)};
  Totals totals;
  ordered_json mismatches = ordered_json::array();
  const Stopwatch watch;
  for (const Scenario& s : scenarios) {
    const int line = static_cast<int>(s.line);
    if (s.width != grid.width || s.height != grid.height)
      throw InputError(scen_name, line,
                       fmt::format("is for a map of {} x {} cells, {} has {} x {}", s.width, s.height, map_name,
                                   grid.width, grid.height));
    for (const GridPlace p : {GridPlace{s.start_row, s.start_column}, GridPlace{s.goal_row, s.goal_column}})
      if (!grid.free(p.column, p.row))
        throw InputError(scen_name, line, fmt::format("column {}, row {} is blocked or outside", p.column, p.row));
    const GridResult result = search.find({s.start_row, s.start_column}, {s.goal_row, s.goal_column}, query);
    const double cost = result.cost.value();
    totals.steps += result.steps;
    if (result.status == GridStatus::found) totals.cost += cost;
    if (result.status == GridStatus::found && agrees(cost, s)) {
      ++totals.matched;
      continue;
    }
    ++totals.missed;
    totals.shorter += result.status == GridStatus::found && cost > s.optimal;
    const std::string found = result.status == GridStatus::found ? fmt::format("{:.8f}", cost) : "no path";
    note(fmt::format("{}:{}: says {}, found {}", scen_name, s.line, s.optimal_text, found));
    mismatches.push_back({{"line", s.line}, {"expected", s.optimal_text}, {"found", found}});
  }
  totals.seconds = watch.seconds();
  if (totals.missed > 0 && totals.shorter == totals.missed)
    note(
        "all that differ are shorter in the file, as any-angle lengths between corners of cells are: `taut batch` "
        "checks "
        "those");
  begin_stage("write");
  const ordered_json all{{"scenarios", scenarios.size()}, {"matched", totals.matched},
                         {"mismatches", mismatches},      {"algorithm", name(options.algorithm)},
                         {"steps", totals.steps},         {"cost", totals.cost},
                         {"seconds", totals.seconds}};
  finish();
  if (!options.json.empty()) write_file(options.json, detail::json_text(all));
  if (options.json != "-")
    print(fmt::format("{}: {}, {} as the file says, {}; {}, total cost {:.6f}, {}\n", scen_name,
                      count_text(scenarios.size(), "scenario"), totals.matched,
                      count_text(totals.missed, "mismatch", "mismatches"), count_text(totals.steps, "step"),
                      totals.cost, seconds_text(totals.seconds)));
  return totals.missed == 0 ? kFound : kNone;
}

}  // namespace

Command grid_scenario_command(CommandLine& grid) {
  return command<ScenarioOptions>(
      grid, "scen",
      "Run a MovingAI scenario file and check each optimal length to its own digits (exit 1: some differ)", add_options,
      run);
}

}  // namespace taut::cli
