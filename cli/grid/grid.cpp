// taut grid: discrete searches on grid maps. What its subcommands share.
#include <taut/cli/grid/grid.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include <taut/cli/command.h>
#include <taut/cli/options.h>
#include <taut/cli/world/foreign.h>
#include <taut/geometry/errors.h>
#include <taut/io/results/words.h>
#include <taut/io/worlds/grid_formula.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

namespace {

bool is_movingai(std::string_view text) {
  return text.substr(0, text.find('\n')).find("type") != std::string_view::npos;
}

// A drawing's first line has none; `0, 1, 0` of a csv may.
bool has_blanks(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  return line.find_first_of(" \t") != std::string_view::npos &&
         line.find_first_not_of("01, \t\r") != std::string_view::npos;
}

/// The place, which must be free.
GridPlace checked(GridPlace place, const OccupancyGrid& grid, const char* option, const std::string& source) {
  if (grid.free(place.column, place.row)) return place;
  const char* const fault = grid.contains(place.column, place.row) ? "blocked in" : "outside";
  throw InputError(source, 0,
                   fmt::format("{} {},{} is {} the grid of {} rows and {} columns", option, place.row, place.column,
                               fault, grid.height, grid.width));
}

template <class Value>
void add_value(CommandLine& app, const char* option, Value& value, auto(*of)(const std::string&), const char* type,
               const std::string& text, const char* group) {
  app.add_option_function(
         option, [&value, of](const std::string& word) { value = of(word); }, text)
      .type_name(type)
      .group(group);
}

}  // namespace

GridPlace grid_place_of(const std::string& text) {
  GridPlace place;
  const char* const end = text.data() + text.size();
  const auto row = std::from_chars(text.data(), end, place.row);
  if (row.ec == std::errc() && row.ptr != end && *row.ptr == ',') {
    const auto column = std::from_chars(row.ptr + 1, end, place.column);
    if (column.ec == std::errc() && column.ptr == end) return place;
  }
  throw UsageError("'" + text + "' is no cell; cells are written ROW,COLUMN, from 0");
}

GridMoves grid_moves_of(const std::string& text) {
  if (const auto moves = grid_moves_named(text)) return *moves;
  throw UsageError("'" + text + "' are no moves; they are 4, 8 and octile");
}

GridHeuristic grid_heuristic_of(const std::string& text) {
  try {
    return grid_heuristic(text);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

GridAlgorithm grid_algorithm_of(const std::string& text) {
  if (const auto algorithm = grid_algorithm_named(text)) return *algorithm;
  std::vector<Choice> all;
  for (std::size_t i = 0; i < kGridAlgorithms; ++i) all.emplace_back(name(static_cast<GridAlgorithm>(i)), "");
  throw not_one_of(text, all);
}

double grid_weight_of(const std::string& text) {
  const double weight = number_of(text, "--weight");
  if (weight < 1 || weight > 1000) throw UsageError("--weight: '" + text + "' is not 1 to 1000");
  return weight;
}

void add_grid_options(CommandLine& app, GridOptions& options, bool with_start) {
  app.add_option("FILE", options.file, "A grid map: csv, MovingAI map or drawing; - is standard input").required();
  add_value(app, "--moves", options.moves, &grid_moves_of, "RULE",
            "4, 8 (diagonal moves past corners too) or octile (only where both cells beside are free); default: 4, "
            "octile in MovingAI maps and for jps",
            "Query");
  if (with_start)
    add_value(app, "--start", options.start, &grid_place_of, "ROW,COLUMN",
              "Start here instead of where FILE says, counted from 0", "Query");
  add_value(app, "--goal", options.goal, &grid_place_of, "ROW,COLUMN", "Go here instead of where FILE says", "Query");
  if (with_start) app.renamed("--from", "--start");
  app.renamed("--to", "--goal");
}

GridInput read_grid_input(const GridOptions& options, bool with_start) {
  const std::string text = read_bytes(options.file), source = source_name(options.file);
  // What a drawing looks like may be a world's first line, too.
  const FileKind drawing = is_movingai(text) || !has_blanks(text) ? FileKind::world : FileKind::grid_csv;
  GridInput input{read_own(text, source, {FileKind::grid_csv, drawing}, [&] { return read_grid(text, source); }),
                  GridMoves::four, source};
  if (options.start) input.task.start = checked(*options.start, input.task.grid, "--start", source);
  if (options.goal) input.task.goal = checked(*options.goal, input.task.grid, "--goal", source);
  if (with_start && !input.task.start) throw InputError(source, 0, "says no start; give one with --start ROW,COLUMN");
  if (!input.task.goal) throw InputError(source, 0, "says no goal; give one with --goal ROW,COLUMN");
  input.moves = options.moves.value_or(is_movingai(text) ? GridMoves::octile : GridMoves::four);
  return input;
}

std::size_t grid_budget(GridAlgorithm algorithm) {
  if (algorithm == GridAlgorithm::greedy) return 1'000'000;
  return algorithm == GridAlgorithm::idastar ? 10'000'000 : SIZE_MAX;
}

GridQuery grid_query(const GridSearchOptions& options, GridMoves moves) {
  GridQuery query{options.algorithm, natural_heuristic(moves)};
  if (options.algorithm == GridAlgorithm::greedy || options.algorithm == GridAlgorithm::greedy_once)
    query.heuristic = {{GridEstimate::euclidean}};
  if (options.heuristic) query.heuristic = *options.heuristic;
  query.ties = options.ties;
  query.weight = static_cast<std::uint32_t>(std::llround(options.weight * 1000));
  query.max_steps = options.max_steps.value_or(grid_budget(options.algorithm));
  return query;
}

GridMoves moves_for(GridAlgorithm algorithm, const GridOptions& options, const GridInput& input) {
  return !options.moves && algorithm == GridAlgorithm::jps && input.moves == GridMoves::four ? GridMoves::octile
                                                                                             : input.moves;
}

GridResult checked_search(const GridInput& input, GridMoves moves, const GridQuery& query) {
  const GridPlace start = *input.task.start, goal = *input.task.goal;
  GridResult result = GridSearch(input.task.grid, moves).find(start, goal, query);
  if (result.status != SearchStatus::found) return result;
  const GridPathVerdict check = verify_grid_path(input.task.grid, moves, start, goal, result.path);
  if (!check.fault.empty()) throw std::logic_error("the path found does not pass the check: " + check.fault);
  if (check.cost != result.cost) throw std::logic_error("the path found does not cost what the search says");
  return result;
}

Outcome outcome_of(SearchStatus status) {
  return status == SearchStatus::found  ? Outcome::found
         : status == SearchStatus::none ? Outcome::none
                                        : Outcome::stopped;
}

void explain_grid_algorithms(CommandLine& app) {
  app.explain("Algorithms", {{"bfs", "first in, first out: the fewest moves"},
                             {"dfs", "the first neighbour not yet taken, as deep as it goes"},
                             {"dijkstra", "the least cost so far first"},
                             {"greedy", "the least estimate first; a cell may be taken again and again"},
                             {"greedy-once", "the same, each cell once"},
                             {"astar", "the least cost so far plus estimate first (default)"},
                             {"weighted-astar", "the same with the estimate times --weight: within that of the least"},
                             {"bidirectional-astar", "A* from both ends"},
                             {"idastar", "depth first within a bound on cost plus estimate that grows"},
                             {"jps", "A* that jumps along straight lines; diagonal moves only"}});
}

void explain_grid_heuristics(CommandLine& app) {
  app.explain("Heuristics", {{"zero", "no estimate"},
                             {"manhattan", "rows plus columns: too much where moves are diagonal"},
                             {"euclidean", "the straight line"},
                             {"chebyshev", "the larger of rows and columns"},
                             {"octile", "the way on an empty grid with diagonal moves"},
                             {"biased-row", "rows, negative above the goal"},
                             {"biased-column", "columns, negative left of the goal"},
                             {"exact", "the true cost, by a search backwards beforehand"}});
}

std::vector<std::string> facts_of(const GridResult& result) {
  std::vector<std::string> all{count_text(result.steps, "step")};
  if (result.status == SearchStatus::found) {
    all.push_back("cost " + cost_text(result.cost));
    all.push_back(count_text(result.path.size(), "cell"));
    all.emplace_back(result.optimal ? "proven least" : "not proven least");
  } else {
    const bool none = result.status == SearchStatus::none;
    all.emplace_back(none ? "no path" : "stopped: out of steps, --max-steps allows more");
  }
  return all;
}

std::string cost_text(GridCost cost) {
  if (cost.diagonal() == 0) return fmt::format("{}", cost.straight());
  if (cost.straight() == 0) return fmt::format("{} sqrt(2)", cost.diagonal());
  return fmt::format("{} + {} sqrt(2)", cost.straight(), cost.diagonal());
}

std::string place_text(GridPlace place) { return fmt::format("({},{})", place.row, place.column); }

std::vector<Command> grid_commands(CommandLine& app) {
  CommandLine grid = command_group(app, "grid", "Discrete searches on grid maps, side by side");
  std::vector<Command> commands;
  commands.push_back(grid_solve_command(grid));
  commands.push_back(grid_compare_command(grid));
  commands.push_back(grid_heuristics_command(grid));
  commands.push_back(grid_scenario_command(grid));
  commands.push_back(grid_generate_command(grid));
  return commands;
}

}  // namespace taut::cli
