// taut solve --anytime: a path soon, then better ones, each with a proven bound.
#pragma once

#include <optional>
#include <string>

#include <taut/cli/command_line.h>
#include <taut/search/anytime_search.h>
#include <taut/search/roadmap_kinds.h>

namespace taut::cli {

struct AnytimeOptions {
  bool wanted = false;
  std::optional<double> epsilon{};

  double first_epsilon() const { return epsilon.value_or(3); }
};

/// --anytime, --epsilon E.
void add_anytime_options(CommandLine& app, AnytimeOptions& options);

/// Throws UsageError: --epsilon needs --anytime, and that a roadmap which is a graph and no other search. `kind` is the
/// one asked for, if any; `method_given`: there is --algorithm or --heuristic.
void require_anytime_fits(const AnytimeOptions& options, const RoadmapKind* kind, bool method_given);

/// How much of --max-seconds a search may use when `spent` are over: a tenth, at least 20 ms, is kept for checking the
/// path and writing it, but never more than half of what is left.
double seconds_for_search(double most, double spent);

/// A line for people: `epsilon 3: length 77.262691, bound 1.0313, 120 expanded, 0.004 s`.
std::string improvement_text(const AnytimeImprovement& stage);

/// `1`, `1.0313`: four decimals, never below the bound.
std::string bound_text(double bound);

}  // namespace taut::cli
