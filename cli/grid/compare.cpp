// taut grid compare: all searches on one map.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include <taut/cli/command.h>
#include <taut/cli/grid/search_options.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/report_files.h>
#include <taut/cli/run.h>
#include <taut/io/pictures/grid_svg.h>
#include <taut/io/results/grid_json.h>

namespace taut::cli {

namespace {

struct GridCompareOptions {
  GridOptions grid;
  GridSearchOptions search;
  CommonOptions common;
  std::string svg;
  ReportOptions report;
};

void add_options(CommandLine& app, GridCompareOptions& options) {
  add_grid_options(app, options.grid);
  add_grid_search_options(app, options.search);
  add_svg_option(app, options.svg, "Draw them side by side: visited cells by order, frontier and path");
  add_csv_option(app, options.report);
  add_html_option(app, options.report);
  explain_grid_algorithms(app);
  explain_grid_heuristics(app);
  app.example("taut grid compare data/pocket.csv --moves octile --svg searches.svg");
}

/// Throws std::logic_error where two that prove the least cost with the same moves do not agree.
class LeastCosts {
 public:
  void add(GridMoves moves, const GridResult& result) {
    if (!result.optimal) return;
    std::optional<GridCost>& known = least_[static_cast<std::size_t>(moves)];
    if (known.value_or(result.cost) != result.cost) throw std::logic_error("two searches prove different least costs");
    known = result.cost;
  }

 private:
  std::array<std::optional<GridCost>, 3> least_;
};

// Of the table's column.
std::size_t heuristic_width(const GridSearchOptions& search) {
  return std::max<std::size_t>(14, search.heuristic ? name(*search.heuristic).size() : 0);
}

std::string row_of(const GridSearchOptions& options, const GridQuery& query, GridMoves moves, const GridResult& result,
                   double seconds) {
  const bool found = result.status == SearchStatus::found;
  return fmt::format("{:<20} {:<6} {:<{}} {:<8} {:>9} {:>7} {:>22} {:>8} {:>9}\n", name(query.algorithm), name(moves),
                     is_informed(query.algorithm) ? name(query.heuristic) : "", heuristic_width(options),
                     name(result.status), result.steps, result.path.size(), found ? cost_text(result.cost) : "",
                     result.optimal ? "yes" : "", seconds_text(seconds));
}

Json json_of(const GridQuery& query, GridMoves moves, const GridResult& result, double seconds) {
  Json json = grid_result_json(result, query, moves);
  json["status"] = name(result.status);
  json["seconds"] = seconds;
  return json;
}

GridPicture picture_of(const GridQuery& query, GridMoves moves, GridResult result, const GridTask& task) {
  std::vector<std::string> facts{fmt::format("{} moves", name(moves))};
  if (is_informed(query.algorithm)) facts.push_back(name(query.heuristic));
  for (std::string& fact : facts_of(result)) facts.push_back(std::move(fact));
  return {std::string(name(query.algorithm)),
          std::move(facts),
          std::move(result.visited),
          std::move(result.frontier),
          std::move(result.path),
          task.start,
          task.goal};
}

int compare(const GridCompareOptions& options, Run& run) {
  run.promise(options.svg);
  promise_reports(options.report, run);
  run.source(options.grid.file);
  const GridInput input = run.stage("read", [&] { return read_grid_input(options.grid); });
  std::string table =
      fmt::format("{:<20} {:<6} {:<{}} {:<8} {:>9} {:>7} {:>22} {:>8} {:>9}\n", "algorithm", "moves", "heuristic",
                  heuristic_width(options.search), "status", "steps", "cells", "cost", "least", "cpu");
  Json all{{"searches", Json::array()}};
  SearchStatus best = SearchStatus::stopped;
  LeastCosts least;
  std::vector<GridPicture> pictures;
  const TellProgress show = shown_progress(options.common);
  ProgressCount done("searches", kGridAlgorithms, show);
  for (std::size_t i = 0; i < kGridAlgorithms; ++i, done.add()) {
    GridSearchOptions search = options.search;
    search.algorithm = static_cast<GridAlgorithm>(i);
    const GridMoves moves = moves_for(search.algorithm, options.grid, input);
    if (search.algorithm == GridAlgorithm::jps && moves == GridMoves::four) continue;
    GridQuery query = grid_query(search, moves);
    query.record = !options.svg.empty();
    const double before = run.seconds("search").cpu;
    GridResult result = run.stage("search", [&] { return checked_search(input, moves, query); });
    const double seconds = run.seconds("search").cpu - before;
    least.add(moves, result);
    best = std::min(best, result.status);  // a path, or a proof that there is none, by any of them is an answer
    table += row_of(options.search, query, moves, result, seconds);
    all["searches"].push_back(json_of(query, moves, result, seconds));
    run.so_far(all, table);
    if (query.record) pictures.push_back(picture_of(query, moves, std::move(result), input.task));
  }
  std::vector<OutputFile> files;
  if (!options.svg.empty())
    files.push_back({options.svg, run.stage("draw", [&] {
                       return grid_comparison_svg(input.task.grid, pictures, title_of(input.name), {});
                     })});
  Answer answer{.outcome = outcome_of(best),
                .reason = best == SearchStatus::stopped ? "--max-steps, of every search"
                          : best == SearchStatus::none  ? "all cells that can be reached from the start were looked at"
                                                        : "",
                .result = std::move(all),
                .line = std::move(table),
                .files = std::move(files)};
  add_reports(answer, options.report, title_of(input.name), "algorithm");
  return run.end(std::move(answer));
}

}  // namespace

Command grid_compare_command(CommandLine& grid) {
  return command<GridCompareOptions>(grid, "compare", "All searches on one grid: steps, cost, time", add_options,
                                     compare);
}

}  // namespace taut::cli
