// What the subcommands of `taut grid` share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/cli/command_line.h>
#include <taut/io/results/envelope.h>
#include <taut/io/worlds/grid_csv.h>
#include <taut/search/grid/grid_search.h>

namespace taut::cli {

/// Which map, which moves, from where to where.
struct GridOptions {
  std::string file;
  std::optional<GridMoves> moves;  ///< when given
  std::optional<GridPlace> start;
  std::optional<GridPlace> goal;
};

void add_grid_options(CommandLine& app, GridOptions& options, bool with_start = true);

/// Of a search: --algorithm, --heuristic, --ties, --weight, --max-steps.
struct GridSearchOptions {
  GridAlgorithm algorithm = GridAlgorithm::astar;
  std::optional<GridHeuristic> heuristic;  ///< when given
  Ties ties = Ties::fifo;
  double weight = 1.5;
  std::optional<std::size_t> max_steps;
};

/// A map, read, and what the options make of it.
struct GridInput {
  GridTask task;
  GridMoves moves = GridMoves::four;
  std::string name;
};

/// Throws InputError: not readable, no start or goal (`with_start`: is a start needed?).
GridInput read_grid_input(const GridOptions& options, bool with_start = true);

/// The query that the options ask for; what they leave open is as --help says.
GridQuery grid_query(const GridSearchOptions& options, GridMoves moves);

/// The steps that may be taken when nothing is said: greedy and idastar can take exponentially many, greedy with as
/// much memory.
std::size_t grid_budget(GridAlgorithm algorithm);

/// Four neighbours, but octile in MovingAI's maps and for jump point search, when nothing is said.
GridMoves moves_for(GridAlgorithm algorithm, const GridOptions& options, const GridInput& input);

/// What the search finds, its path replayed against the map. Throws std::logic_error where the two differ.
GridResult checked_search(const GridInput& input, GridMoves moves, const GridQuery& query);

/// found, none or stopped.
Outcome outcome_of(SearchStatus status);

/// What is said of a result: steps, cost, cells, is it proven.
std::vector<std::string> facts_of(const GridResult& result);
/// `7`, `3 + 2 sqrt(2)`: exact.
std::string cost_text(GridCost cost);
/// `(2,5)`: row and column.
std::string place_text(GridPlace place);

// Values of options. Throw UsageError.
GridPlace grid_place_of(const std::string& text);
GridMoves grid_moves_of(const std::string& text);
GridHeuristic grid_heuristic_of(const std::string& text);
GridAlgorithm grid_algorithm_of(const std::string& text);
double grid_weight_of(const std::string& text);  ///< 1 to 1000

/// A line for each algorithm and each heuristic, for --help.
void explain_grid_algorithms(CommandLine& app);
void explain_grid_heuristics(CommandLine& app);

}  // namespace taut::cli
