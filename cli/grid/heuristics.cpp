// taut grid heuristics: which estimates can be trusted on a map.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/grid/grid.h>
#include <taut/cli/output.h>
#include <taut/cli/timing.h>
#include <taut/io/results/detail/result_values.h>

namespace taut::cli {

namespace {

using nlohmann::ordered_json;

struct HeuristicsOptions {
  GridOptions grid;
  CommonOptions common;
  std::vector<GridHeuristic> chosen;
  std::string json;
};

void add_options(CommandLine& app, HeuristicsOptions& options) {
  add_grid_options(app, options.grid, false);
  app.add_each_function(
         "--heuristic", [&options](const std::string& word) { options.chosen.push_back(grid_heuristic_of(word)); },
         "Only this one, or a maximum of several joined by commas (default: each of " + grid_estimate_names() + ")")
      .type_name("NAME")
      .group("Search");
  app.add_option("--json", options.json, "Write the verdicts as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
}

std::string why_not_admissible(const Overestimate& o) {
  return fmt::format("h{} = {:.6g}, but the true cost is {}", place_text(o.cell), o.estimate, cost_text(o.cost));
}

std::string why_not_consistent(const InconsistentMove& m) {
  if (m.from == m.to) return fmt::format("h{} = {:.6g} in the goal itself", place_text(m.from), m.estimate_from);
  return fmt::format("h{} = {:.6g}, h{} = {:.6g}, and the move costs {}", place_text(m.from), m.estimate_from,
                     place_text(m.to), m.estimate_to, cost_text(m.cost));
}

ordered_json place_json(GridPlace p) { return ordered_json::array({p.row, p.column}); }

ordered_json json_of(const GridHeuristic& heuristic, const HeuristicVerdict& verdict) {
  ordered_json out;
  out["heuristic"] = name(heuristic);
  out["admissible"] = verdict.admissible();
  out["consistent"] = verdict.consistent();
  if (const auto& o = verdict.overestimate)
    out["overestimate"] = {{"cell", place_json(o->cell)}, {"h", o->estimate}, {"cost", o->cost.value()}};
  if (const auto& m = verdict.violation)
    out["violation"] = {{"from", place_json(m->from)},
                        {"to", place_json(m->to)},
                        {"h_from", m->estimate_from},
                        {"h_to", m->estimate_to},
                        {"cost", m->cost.value()}};
  return out;
}

int run(const HeuristicsOptions& options) {
  require_writable(options.json);
  double read = 0;
  const GridInput input = timed("read", read, [&] { return read_grid_input(options.grid, false); });
  begin_stage("search");
  std::vector<GridHeuristic> heuristics = options.chosen;
  if (heuristics.empty())
    for (int e = 0; e <= static_cast<int>(GridEstimate::exact); ++e)
      heuristics.push_back({{static_cast<GridEstimate>(e)}});
  std::string text;
  ordered_json all;
  all["source"] = input.name;
  all["moves"] = name(input.moves);
  all["goal"] = place_json(*input.task.goal);
  all["heuristics"] = ordered_json::array();
  for (const GridHeuristic& heuristic : heuristics) {
    const HeuristicVerdict verdict = heuristic_verdict(input.task.grid, input.moves, *input.task.goal, heuristic);
    text += fmt::format("{:<14} {:<14} {:<14}", name(heuristic), verdict.admissible() ? "admissible" : "not admissible",
                        verdict.consistent() ? "consistent" : "not consistent");
    if (verdict.overestimate) text += "  " + why_not_admissible(*verdict.overestimate);
    if (verdict.violation) text += (verdict.overestimate ? "; " : "  ") + why_not_consistent(*verdict.violation);
    while (text.back() == ' ') text.pop_back();
    text += "\n";
    all["heuristics"].push_back(json_of(heuristic, verdict));
  }
  begin_stage("write");
  finish();
  if (!options.json.empty()) write_file(options.json, detail::json_text(all));
  if (options.json != "-") print(text);
  return kFound;
}

}  // namespace

Command grid_heuristics_command(CommandLine& grid) {
  return command<HeuristicsOptions>(grid, "heuristics",
                                    "Is each heuristic admissible and consistent on a map? With a witness where not",
                                    add_options, run);
}

}  // namespace taut::cli
