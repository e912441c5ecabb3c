// The options of `taut solve`.
#pragma once

#include <optional>
#include <string>

#include <taut/cli/command_line.h>
#include <taut/cli/options.h>
#include <taut/cli/path_files.h>
#include <taut/cli/solve/anytime.h>
#include <taut/cli/solve/prm_options.h>
#include <taut/search/clearance_planner.h>
#include <taut/search/graph_search.h>
#include <taut/search/roadmap_kinds.h>

namespace taut::cli {

struct SolveOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  std::optional<GraphAlgorithm> algorithm;
  std::optional<GraphHeuristic> heuristic;
  AnytimeOptions anytime;
  std::optional<ClearanceQuery> clearance;
  std::optional<double> keep;    // the clearance of --keep
  std::size_t alternatives = 0;  // how many ways
  bool wider = false;            // those that no shorter one is as wide as
  bool no_verify = false;
  bool path = false;
  bool shorten = false;
  PrmRequest prm;
  bool arcs = false;
  const RoadmapKind* kind = nullptr;  // when it is given
  std::string svg;
  std::string animation;     // of --tradeoff
  std::size_t contours = 0;  // lines of equal distance in the picture
  PathFiles files;
  std::string certificate;
  std::string save;
  std::string load;

  bool tradeoff() const { return clearance && clearance->kind == ClearanceQuery::Kind::tradeoff; }
  bool ways_given() const { return alternatives > 0 || wider; }
  /// Was one asked for that works on a graph?
  bool method_given() const { return algorithm || heuristic; }
  GraphMethod method() const {
    return {algorithm.value_or(GraphAlgorithm::astar), heuristic.value_or(GraphHeuristic::euclidean)};
  }
};

/// Adds them all. Those that exclude each other are a UsageError (exit 2).
void add_solve_options(CommandLine& app, SolveOptions& options);

}  // namespace taut::cli
