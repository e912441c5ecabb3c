// taut grid solve, taut grid compare: one search, or all of them.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/grid/grid.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/io/pictures/grid_svg.h>
#include <taut/io/results/detail/result_values.h>

namespace taut::cli {

namespace {

using nlohmann::ordered_json;

struct GridSolveOptions {
  GridOptions grid;
  GridSearchOptions search;
  CommonOptions common;
  std::string svg;
  std::string animation;
  std::string json;
  bool path = false;
};

void add_search_options(CommandLine& app, GridSearchOptions& options) {
  app.add_option_function(
         "--heuristic", [&options](const std::string& text) { options.heuristic = grid_heuristic_of(text); },
         grid_estimate_names() +
             "; several joined by commas: their maximum. Default: manhattan with 4 neighbours, "
             "else octile; euclidean for greedy")
      .type_name("NAME")
      .group("Search");
  app.add_option_function(
         "--ties",
         [&options](const std::string& text) {
           if (text != "fifo" && text != "lifo") throw UsageError("--ties are fifo or lifo, not '" + text + "'");
           options.ties = text == "fifo" ? Ties::fifo : Ties::lifo;
         },
         "Among equals the oldest (fifo, default) or the newest (lifo) first")
      .type_name("ORDER")
      .group("Search");
  app.add_option_function(
         "--weight", [&options](const std::string& text) { options.weight = grid_weight_of(text); },
         "Of weighted-astar, 1 to 1000 (default: 1.5)")
      .type_name("W")
      .group("Search");
  app.add_option_function(
         "--max-steps", [&options](const std::string& text) { options.max_steps = grid_steps_of(text); },
         "Stop after so many steps, with exit code 4 (default: 1000000 for greedy, 10000000 for idastar, which can "
         "take "
         "exponentially many; no limit for the others)")
      .type_name("N")
      .group("Limits");
}

void add_options(CommandLine& app, GridSolveOptions& options) {
  add_grid_options(app, options.grid);
  app.add_option_function(
         "--algorithm", [&options](const std::string& text) { options.search.algorithm = grid_algorithm_of(text); },
         "bfs, dfs, dijkstra, greedy (a cell may be taken again and again, as in reports that call it A*), "
         "greedy-once, "
         "astar (default), weighted-astar, bidirectional-astar, idastar, jps")
      .type_name("NAME")
      .group("Search");
  add_search_options(app, options.search);
  app.add_option("--svg", options.svg, "Draw visited cells by order, frontier and path; - is standard output")
      .type_name("FILE")
      .group("Output");
  add_animate_option(app, options.animation, "The same as an SVG that plays in a browser");
  app.add_option("--json", options.json, "Write the result as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_flag("--path", options.path, "Print the cells of the path, one `row,column` a line").group("Output");
  app.callback([&app, &options] {
    settle_animation(app, options.animation, options.svg, options.json);
    if (options.search.algorithm == GridAlgorithm::jps && options.grid.moves == GridMoves::four)
      throw UsageError("jps jumps along diagonals: not with --moves 4");
  });
}

GridMoves moves_for(GridAlgorithm algorithm, const GridOptions& options, const GridInput& input) {
  return !options.moves && algorithm == GridAlgorithm::jps && input.moves == GridMoves::four ? GridMoves::octile
                                                                                             : input.moves;
}

int exit_code(GridStatus status) {
  return status == GridStatus::found ? kFound : status == GridStatus::none ? kNone : kStopped;
}

bool is_informed(GridAlgorithm a) {
  return a != GridAlgorithm::bfs && a != GridAlgorithm::dfs && a != GridAlgorithm::dijkstra;
}

ordered_json place_json(GridPlace p) { return ordered_json::array({p.row, p.column}); }

ordered_json json_of(const GridResult& result, const GridQuery& query, GridMoves moves, double seconds) {
  ordered_json out;
  out["status"] = name(result.status);
  if (result.status == GridStatus::stopped) out["reason"] = fmt::format("--max-steps {}", query.max_steps);
  out["algorithm"] = name(query.algorithm);
  if (is_informed(query.algorithm)) out["heuristic"] = name(query.heuristic);
  out["moves"] = name(moves);
  out["ties"] = query.ties == Ties::fifo ? "fifo" : "lifo";
  out["steps"] = result.steps;
  if (result.status == GridStatus::found) {
    out["cost"] = result.cost.value();
    out["straight"] = result.cost.straight();
    out["diagonal"] = result.cost.diagonal();
    out["optimal"] = result.optimal;
  } else {
    out["cost"] = nullptr;
  }
  out["cells"] = result.path.size();
  out["path"] = ordered_json::array();
  for (const GridPlace& p : result.path) out["path"].push_back(place_json(p));
  out["seconds"] = seconds;
  return out;
}

std::string title(const GridQuery& query) {
  std::string text(name(query.algorithm));
  return is_informed(query.algorithm) ? text + " (" + name(query.heuristic) + ")" : text;
}

std::vector<std::string> facts(const GridResult& result) {
  std::vector<std::string> all{count_text(result.steps, "step")};
  if (result.status == GridStatus::found) {
    all.push_back("cost " + cost_text(result.cost));
    all.push_back(count_text(result.path.size(), "cell"));
    all.push_back(result.optimal ? "proven least" : "not proven least");
  } else {
    all.push_back(result.status == GridStatus::none ? "no path" : "stopped: out of steps, --max-steps allows more");
  }
  return all;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// The JSON says so when a limit or an interrupt ends the search.
void prepare_last_words(const GridSolveOptions& options) {
  if (options.json.empty()) return;
  on_stop([file = options.json, algorithm = std::string(name(options.search.algorithm))](const Stop& why) {
    const ordered_json out{{"status", name(GridStatus::stopped)},
                           {"reason", why.reason},
                           {"stage", why.stage},
                           {"algorithm", algorithm},
                           {"cost", nullptr},
                           {"cells", 0},
                           {"path", ordered_json::array()}};
    write_file(file, detail::json_text(out));
  });
}

int solve(const GridSolveOptions& options) {
  for (const std::string* file : {&options.svg, &options.animation, &options.json}) require_writable(*file);
  prepare_last_words(options);
  double read = 0, seconds = 0;
  const GridInput input = timed("read", read, [&] { return read_grid_input(options.grid); });
  const GridMoves moves = moves_for(options.search.algorithm, options.grid, input);
  GridQuery query = grid_query(options.search, moves);
  query.record = !options.svg.empty() || !options.animation.empty();
  GridSearch search(input.task.grid, moves);
  const GridResult result =
      timed("search", seconds, [&] { return search.find(*input.task.start, *input.task.goal, query); });
  if (result.status == GridStatus::found) {
    const GridPathCheck check =
        grid_path_check(input.task.grid, moves, *input.task.start, *input.task.goal, result.path);
    if (!check.fault.empty() || check.cost != result.cost) {
      complain("internal error: the path found does not pass the check" +
               (check.fault.empty() ? "" : ": " + check.fault));
      return kInternal;
    }
  }
  begin_stage("write");
  GridPicture picture{title_of(input.name) + ", " + title(query),
                      facts(result),
                      result.visited,
                      result.frontier,
                      result.path,
                      input.task.start,
                      input.task.goal,
                      false};
  const std::string still = options.svg.empty() ? "" : grid_svg(input.task.grid, picture);
  picture.animated = true;
  const std::string playing = options.animation.empty() ? "" : grid_svg(input.task.grid, picture);
  finish();
  write_file(options.svg, still);
  write_file(options.animation, playing);
  if (!options.json.empty()) write_file(options.json, detail::json_text(json_of(result, query, moves, seconds)));
  if (options.path)
    for (const GridPlace& p : result.path) print(fmt::format("{},{}\n", p.row, p.column));
  else if (options.svg != "-" && options.animation != "-" && options.json != "-")
    print(fmt::format("{}: {}: {}, {}\n", input.name, title(query), joined(facts(result)), seconds_text(seconds)));
  return exit_code(result.status);
}

struct GridCompareOptions {
  GridOptions grid;
  GridSearchOptions search;
  CommonOptions common;
  std::string json;
};

void add_compare_options(CommandLine& app, GridCompareOptions& options) {
  add_grid_options(app, options.grid);
  add_search_options(app, options.search);
  app.add_option("--json", options.json, "Write the table as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
}

std::string row_of(const GridQuery& query, GridMoves moves, const GridResult& result, double seconds) {
  const bool found = result.status == GridStatus::found;
  return fmt::format("{:<20} {:<6} {:<14} {:<8} {:>9} {:>7} {:>22} {:>8} {:>9}\n", name(query.algorithm), name(moves),
                     is_informed(query.algorithm) ? name(query.heuristic) : "", name(result.status), result.steps,
                     result.path.size(), found ? cost_text(result.cost) : "", result.optimal ? "yes" : "",
                     seconds_text(seconds));
}

/// Also says whether all that claim the least cost with the same moves agree.
int compare(const GridCompareOptions& options) {
  require_writable(options.json);
  double read = 0;
  const GridInput input = timed("read", read, [&] { return read_grid_input(options.grid); });
  std::string table = fmt::format("{:<20} {:<6} {:<14} {:<8} {:>9} {:>7} {:>22} {:>8} {:>9}\n", "algorithm", "moves",
                                  "heuristic", "status", "steps", "cells", "cost", "least", "time");
  ordered_json all;
  all["source"] = input.name;
  all["searches"] = ordered_json::array();
  GridStatus best = GridStatus::stopped;
  for (std::size_t i = 0; i < kGridAlgorithms; ++i) {
    GridSearchOptions search = options.search;
    search.algorithm = static_cast<GridAlgorithm>(i);
    const GridMoves moves = moves_for(search.algorithm, options.grid, input);
    if (search.algorithm == GridAlgorithm::jps && moves == GridMoves::four) continue;
    const GridQuery query = grid_query(search, moves);
    GridSearch engine(input.task.grid, moves);
    double seconds = 0;
    const GridResult result =
        timed("search", seconds, [&] { return engine.find(*input.task.start, *input.task.goal, query); });
    best = std::min(best, result.status);  // a path, or a proof that there is none, by any of them is an answer
    table += row_of(query, moves, result, seconds);
    all["searches"].push_back(json_of(result, query, moves, seconds));
  }
  begin_stage("write");
  finish();
  if (!options.json.empty()) write_file(options.json, detail::json_text(all));
  if (options.json != "-") print(table);
  return exit_code(best);
}

}  // namespace

Command grid_solve_command(CommandLine& grid) {
  return command<GridSolveOptions>(grid, "solve", "A path on a grid, by the search of your choice, its steps counted",
                                   add_options, solve);
}

Command grid_compare_command(CommandLine& grid) {
  return command<GridCompareOptions>(grid, "compare", "All searches on one grid: steps, cost, time",
                                     add_compare_options, compare);
}

}  // namespace taut::cli
