// Estimates of the cost to the goal that people write down.
#pragma once

#include <string_view>

#include <taut/search/grid/grid_heuristics.h>

namespace taut {

/// An expression of `cx`, `cy` (a cell's column and row), `gx` and `gy` (the goal's) with + - * / ^, parentheses,
/// comparisons, `a ? b : c`, abs, sqrt, min, max, exp, ln, sin, ... (muParser's), in doubles:
/// `sqrt((cx-gx)^2 + (cy-gy)^2)`. Throws InputError that says what is wrong and where. What it returns may be called
/// from several threads, one at a time gets its turn.
GridFormula grid_formula(std::string_view text);

/// Names as grid_heuristic_named() knows them and formulas, joined by commas (those within parentheses are the
/// formula's own): their maximum. Throws InputError.
GridHeuristic grid_heuristic(std::string_view text);

}  // namespace taut
