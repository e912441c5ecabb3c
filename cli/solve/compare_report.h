// A comparison as a table.
#pragma once

#include <string>

#include <taut/io/results/json.h>
#include <taut/search/planners.h>

namespace taut::cli {

/// One line a planner, columns aligned: solved (`yes`, `no`, of several runs `18/20`), length, ratio to the optimum
/// (`1` only when the lengths are exactly equal), least clearance, vertices, edges, CPU seconds of building and of the
/// query, expansions, verified. Of several runs medians; lengths and clearances are those of the typical run. Planners
/// that did not run are left out.
std::string comparison_table(const Comparison& comparison);

/// Of several worlds or runs, from report_summary() by `name`: one line a planner: the part of runs that were solved,
/// least, quartiles and most of the ratio to the optimum, median and most CPU seconds of building and of the query.
std::string worlds_table(const Json& summary);

}  // namespace taut::cli
