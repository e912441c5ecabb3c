// taut grid solve: one search, drawn and told.
#include <fmt/format.h>

#include <taut/cli/command.h>
#include <taut/cli/grid/search_options.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/io/pictures/grid_svg.h>
#include <taut/io/results/grid_json.h>

namespace taut::cli {

namespace {

struct GridSolveOptions {
  GridOptions grid;
  GridSearchOptions search;
  CommonOptions common;
  std::string svg;
  std::string animation;
  bool path = false;
};

// What is given but would change nothing.
void refuse_idle_options(const CommandLine& app, GridAlgorithm algorithm) {
  const auto refuse = [&](const char* option, bool is_idle) {
    if (is_idle && app.count(option) > 0)
      throw UsageError(fmt::format("{} has no effect on {}", option, name(algorithm)));
  };
  refuse("--heuristic", !is_informed(algorithm));
  refuse("--ties",
         algorithm == GridAlgorithm::bfs || algorithm == GridAlgorithm::dfs || algorithm == GridAlgorithm::idastar);
  refuse("--weight", algorithm != GridAlgorithm::weighted_astar);
}

void add_options(CommandLine& app, GridSolveOptions& options) {
  add_grid_options(app, options.grid);
  app.add_option_function(
         "--algorithm", [&options](const std::string& text) { options.search.algorithm = grid_algorithm_of(text); },
         "Which search, see below (default: astar)")
      .type_name("NAME")
      .group("Search");
  add_grid_search_options(app, options.search);
  add_svg_option(app, options.svg, "Draw visited cells by order, frontier and path");
  add_animate_option(app, options.animation, "The same as an SVG that plays in a browser");
  app.add_flag("--path", options.path, "Print the cells of the path, one `row,column` a line").group("Output");
  app.callback([&app, &options] {
    settle_animation(app, options.animation, options.svg, options.common.json);
    refuse_idle_options(app, options.search.algorithm);
    if (options.search.algorithm == GridAlgorithm::jps && options.grid.moves == GridMoves::four)
      throw UsageError("jps jumps along diagonals: not with --moves 4");
  });
  explain_grid_algorithms(app);
  explain_grid_heuristics(app);
  app.example("taut grid solve data/pocket.csv --algorithm greedy --svg pocket.svg");
  app.example("taut grid solve data/pocket.csv --start 0,0 --goal 4,4 --moves octile");
}

std::string title(const GridQuery& query) {
  std::string text(name(query.algorithm));
  return is_informed(query.algorithm) ? text + " (" + name(query.heuristic) + ")" : text;
}

std::string path_text(const std::vector<GridPlace>& path) {
  std::string text;
  for (const GridPlace& place : path) text += fmt::format("{},{}\n", place.row, place.column);
  return text;
}

std::string reason_of(const GridResult& result, const GridQuery& query) {
  if (result.status == SearchStatus::none) return "all cells that can be reached from the start were looked at";
  return result.status == SearchStatus::stopped ? fmt::format("--max-steps {}", query.max_steps) : "";
}

// Of those that were asked for.
std::vector<OutputFile> pictures(const GridSolveOptions& options, const GridInput& input, GridPicture picture) {
  std::vector<OutputFile> files;
  for (const bool moves : {false, true}) {
    const std::string& file = moves ? options.animation : options.svg;
    picture.animated = moves;
    if (!file.empty()) files.push_back({file, grid_svg(input.task.grid, picture)});
  }
  return files;
}

int solve(const GridSolveOptions& options, Run& run) {
  run.source(options.grid.file);
  for (const std::string& file : {options.svg, options.animation}) run.promise(file);
  const GridInput input = run.stage("read", [&] { return read_grid_input(options.grid); });
  const GridMoves moves = moves_for(options.search.algorithm, options.grid, input);
  GridQuery query = grid_query(options.search, moves);
  query.record = !options.svg.empty() || !options.animation.empty();
  run.so_far({{"algorithm", name(query.algorithm)}, {"cost", nullptr}, {"cells", 0}, {"path", Json::array()}});
  const GridResult result = run.stage("search", [&] { return checked_search(input, moves, query); });
  std::vector<OutputFile> files = run.stage("draw", [&] {
    return pictures(options, input,
                    {title_of(input.name) + ", " + title(query), facts_of(result), result.visited, result.frontier,
                     result.path, input.task.start, input.task.goal, false});
  });
  return run.end({.outcome = outcome_of(result.status),
                  .reason = reason_of(result, query),
                  .result = grid_result_json(result, query, moves),
                  .line = fmt::format("{}: {}: {}, {}\n", input.name, title(query), fmt::join(facts_of(result), ", "),
                                      seconds_text(run.seconds("search").cpu)),
                  .listing = options.path ? path_text(result.path) : "",
                  .files = std::move(files)});
}

}  // namespace

Command grid_solve_command(CommandLine& grid) {
  return command<GridSolveOptions>(grid, "solve", "A path on a grid, by the search of your choice, its steps counted",
                                   add_options, solve);
}

}  // namespace taut::cli
