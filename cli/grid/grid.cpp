// taut grid: discrete searches on grid maps. What its subcommands share.
#include <taut/cli/command_line.h>
#include <taut/cli/grid/grid.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include <taut/cli/command.h>
#include <taut/geometry/errors.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

namespace {

std::string algorithm_names() {
  std::string names;
  for (std::size_t i = 0; i < kGridAlgorithms; ++i)
    names.append(i == 0 ? "" : ", ").append(name(static_cast<GridAlgorithm>(i)));
  return names;
}

bool is_movingai(std::string_view text) {
  return text.substr(0, text.find('\n')).find("type") != std::string_view::npos;
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
  if (auto heuristic = grid_heuristic_named(text)) return *std::move(heuristic);
  throw UsageError("'" + text + "' is no heuristic; they are " + grid_estimate_names() +
                   ", and several joined by commas for their maximum");
}

GridAlgorithm grid_algorithm_of(const std::string& text) {
  if (const auto algorithm = grid_algorithm_named(text)) return *algorithm;
  throw UsageError("'" + text + "' is no algorithm; they are " + algorithm_names());
}

double grid_weight_of(const std::string& text) {
  const double weight = number_of(text, "--weight");
  if (weight < 1 || weight > 1000) throw UsageError("--weight: '" + text + "' is not 1 to 1000");
  return weight;
}

std::size_t grid_steps_of(const std::string& text) {
  std::size_t steps = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, steps);
  if (read.ec != std::errc() || read.ptr != end) throw UsageError("--max-steps: '" + text + "' is no number of steps");
  return steps;
}

void add_grid_options(CommandLine& app, GridOptions& options, bool with_start) {
  app.add_option("FILE", options.file, "A grid map: csv, MovingAI map or drawing; - is standard input").required();
  add_value(app, "--moves", options.moves, &grid_moves_of, "RULE",
            "4, 8 (diagonal moves past corners too) or octile (only where both cells beside are free); default: 4, "
            "octile in MovingAI maps and for jps",
            "Query");
  if (with_start)
    add_value(app, "--from", options.from, &grid_place_of, "ROW,COLUMN", "Start here instead, counted from 0", "Query");
  add_value(app, "--to", options.to, &grid_place_of, "ROW,COLUMN", "Go here instead", "Query");
}

GridInput read_grid_input(const GridOptions& options, bool with_start) {
  const std::string source = options.file == "-" ? "<stdin>" : options.file;
  const std::string text = read_bytes(options.file);
  GridInput input{read_grid(text, source), GridMoves::four, source};
  if (options.from) input.task.start = checked(*options.from, input.task.grid, "--from", source);
  if (options.to) input.task.goal = checked(*options.to, input.task.grid, "--to", source);
  if (with_start && !input.task.start) throw InputError(source, 0, "says no start; give one with --from ROW,COLUMN");
  if (!input.task.goal) throw InputError(source, 0, "says no goal; give one with --to ROW,COLUMN");
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
