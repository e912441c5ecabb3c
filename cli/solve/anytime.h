// taut solve --anytime: a path soon, then better ones, each with a proven bound.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/cli/command_line.h>
#include <taut/cli/solve/roadmap_kinds.h>
#include <taut/search/anytime_search.h>

namespace taut::cli {

struct AnytimeOptions {
  bool wanted = false;
  std::optional<double> epsilon{};  ///< 3 when not given
};

/// --anytime, --epsilon E.
void add_anytime_options(CommandLine& app, AnytimeOptions& options);

/// Throws UsageError: --epsilon needs --anytime, and that a roadmap which is a graph and no other search. `kind` is the
/// one asked for, if any; `method_given`: there is --algorithm or --heuristic.
void require_anytime_fits(const AnytimeOptions& options, const RoadmapKind* kind, bool method_given);

struct AnytimeAnswer {
  GraphSearchResult result;
  double bound = 1;
  bool optimal = false;  ///< in the roadmap
  std::vector<AnytimeImprovement> improvements;
};

/// Searches until the path is proven the shortest or `seconds` are over. found: there is a path, whether proven the
/// shortest or not. stopped: the seconds ended before there was one. `told`: each stage is a line on stderr.
AnytimeAnswer solve_anytime(const PlannedRoadmap& planned, Point from, const Goal& to, const AnytimeOptions& options,
                            double seconds, bool told);

/// How much of --max-seconds a search may use when `spent` are over: a tenth, at least 20 ms, is kept for checking the
/// path and writing it, but never more than half of what is left.
double seconds_for_search(double most, double spent);

/// `1`, `1.0313`: four decimals, never below the bound.
std::string bound_text(double bound);

}  // namespace taut::cli
