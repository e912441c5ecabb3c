#include <taut/cli/grid/search_options.h>

namespace taut::cli {

namespace {

Ties ties_of(const std::string& text) {
  if (text != "fifo" && text != "lifo") throw UsageError("'" + text + "' is not fifo or lifo");
  return text == "fifo" ? Ties::fifo : Ties::lifo;
}

}  // namespace

void add_grid_search_options(CommandLine& app, GridSearchOptions& options) {
  app.add_option_function(
         "--heuristic", [&options](const std::string& text) { options.heuristic = grid_heuristic_of(text); },
         "Which estimate, see below, or an expression of cx, cy (column, row), gx and gy; several joined by commas: "
         "their "
         "maximum. Default: manhattan with 4 neighbours, "
         "else octile; euclidean for greedy")
      .type_name("NAME")
      .group("Search");
  app.add_option_function(
         "--ties", [&options](const std::string& text) { options.ties = ties_of(text); },
         "Among equals the oldest (fifo, default) or the newest (lifo) first")
      .type_name("ORDER")
      .group("Search");
  app.add_option_function(
         "--weight", [&options](const std::string& text) { options.weight = grid_weight_of(text); },
         "Of weighted-astar, 1 to 1000 (default: 1.5)")
      .type_name("W")
      .group("Search");
  app.add_option_function(
         "--max-steps", [&options](const std::string& text) { options.max_steps = count_of(text); },
         "Stop after so many steps, with exit code 4 (default: 1000000 for greedy, 10000000 for idastar, which can "
         "take exponentially many; no limit for the others)")
      .type_name("N")
      .group("Limits");
}

}  // namespace taut::cli
