// Options of one search on a grid, or of all.
#pragma once

#include <taut/cli/grid/grid.h>
#include <taut/cli/options.h>

namespace taut::cli {

/// --heuristic, --ties, --weight, --max-steps.
void add_grid_search_options(CommandLine& app, GridSearchOptions& options);

}  // namespace taut::cli
