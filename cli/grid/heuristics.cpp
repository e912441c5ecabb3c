// taut grid heuristics: which estimates can be trusted on a map.
#include <fmt/format.h>

#include <algorithm>

#include <taut/cli/command.h>
#include <taut/cli/grid/grid.h>
#include <taut/cli/run.h>
#include <taut/io/results/grid_json.h>

namespace taut::cli {

namespace {

struct HeuristicsOptions {
  GridOptions grid;
  CommonOptions common;
  std::vector<GridHeuristic> chosen;
};

void add_options(CommandLine& app, HeuristicsOptions& options) {
  add_grid_options(app, options.grid, false);
  app.add_each_function(
         "--heuristic", [&options](const std::string& word) { options.chosen.push_back(grid_heuristic_of(word)); },
         "Only this one: a name, an expression of cx, cy (column, row), gx and gy, or a maximum of several joined by "
         "commas (default: each, see below)")
      .type_name("NAME")
      .group("Search");
  explain_grid_heuristics(app);
  app.example("taut grid heuristics data/pocket.csv --moves 8 --heuristic manhattan --heuristic octile");
  app.example("taut grid heuristics data/pocket.csv --heuristic 'max(abs(cx-gx), abs(cy-gy)) * 1.1'");
}

std::string why_not_admissible(const Overestimate& o) {
  return fmt::format("h{} = {:.6g}, but the true cost is {}", place_text(o.cell), o.estimate, cost_text(o.cost));
}

std::string why_not_consistent(const InconsistentMove& m) {
  if (m.from == m.to) return fmt::format("h{} = {:.6g} in the goal itself", place_text(m.from), m.estimate_from);
  return fmt::format("h{} = {:.6g}, h{} = {:.6g}, and the move costs {}", place_text(m.from), m.estimate_from,
                     place_text(m.to), m.estimate_to, cost_text(m.cost));
}

std::string line_of(const GridHeuristic& heuristic, std::size_t width, const HeuristicVerdict& verdict) {
  std::string text = fmt::format("{:<{}} {:<14} {:<14}", name(heuristic), width,
                                 verdict.admissible() ? "admissible" : "not admissible",
                                 verdict.consistent() ? "consistent" : "not consistent");
  if (verdict.overestimate) text += "  " + why_not_admissible(*verdict.overestimate);
  if (verdict.violation) text += (verdict.overestimate ? "; " : "  ") + why_not_consistent(*verdict.violation);
  return text.erase(text.find_last_not_of(' ') + 1) + "\n";
}

std::vector<GridHeuristic> all_heuristics() {
  std::vector<GridHeuristic> all;
  for (int e = 0; e <= static_cast<int>(GridEstimate::exact); ++e) all.push_back({{static_cast<GridEstimate>(e)}});
  return all;
}

int run(const HeuristicsOptions& options, Run& run) {
  run.source(options.grid.file);
  const GridInput input = run.stage("read", [&] { return read_grid_input(options.grid, false); });
  std::string text;
  Json all{{"moves", name(input.moves)}, {"goal", grid_place_json(*input.task.goal)}, {"heuristics", Json::array()}};
  const std::vector<GridHeuristic> chosen = options.chosen.empty() ? all_heuristics() : options.chosen;
  std::size_t width = 14;
  for (const GridHeuristic& heuristic : chosen) width = std::max(width, name(heuristic).size());
  for (const GridHeuristic& heuristic : chosen) {
    const HeuristicVerdict verdict = run.stage(
        "search", [&] { return heuristic_verdict(input.task.grid, input.moves, *input.task.goal, heuristic); });
    text += line_of(heuristic, width, verdict);
    all["heuristics"].push_back(heuristic_json(heuristic, verdict));
    run.so_far(all, text);
  }
  return run.end({.result = std::move(all), .line = std::move(text)});
}

}  // namespace

Command grid_heuristics_command(CommandLine& grid) {
  return command<HeuristicsOptions>(grid, "heuristics",
                                    "Is each heuristic admissible and consistent on a map? With a witness where not",
                                    add_options, run);
}

}  // namespace taut::cli
