// Planners that are compared on one world. A further one is one more row in planners.cpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <taut/search/roadmap_kinds.h>
#include <taut/search/stopwatch.h>

namespace taut {

/// A roadmap and how it is searched.
struct Planner {
  const char* name;  ///< in tables and in --planners
  const char* kind;  ///< of roadmap_kinds()
  const char* what;  ///< a line for those who choose
  GraphAlgorithm algorithm = GraphAlgorithm::astar;
  bool shortens = false;  ///< pulls the path taut (shortened)
};

std::span<const Planner> planners();

/// nullptr when there is none of that name.
const Planner* planner(const std::string& name);

/// `visibility-astar, visibility-dijkstra, ...`
std::string planner_names();

/// One run of a planner.
struct PlannerRun {
  bool solved = false;
  Path path;
  std::optional<double> clearance;  ///< of a path: least distance to an obstacle
  bool verified = false;            ///< the independent check accepted the path
  std::size_t vertices = 0;
  std::size_t edges = 0;
  Seconds build;
  Seconds query;
  std::size_t expanded = 0;
  std::shared_ptr<const Roadmap> roadmap{};
  std::optional<PrmCounts> counts{};  ///< of a PRM
};

/// All runs of one planner.
struct PlannerRuns {
  const Planner* planner = nullptr;
  bool optimal = false;          ///< RoadmapKind::optimal
  std::vector<PlannerRun> runs;  ///< one each seed, or one
  std::string unfit{};           ///< why it did not run at all, then `runs` is empty

  std::size_t solved() const;
  /// Did every path pass the independent check?
  bool all_verified() const;
  /// The one that stands for all: the median of those solved by length, or the first when none is.
  const PlannerRun& typical() const;
  /// The median over all runs of one of their numbers, the upper of the two in the middle.
  double median(double (*number)(const PlannerRun&)) const;
};

/// Several planners on one query.
struct Comparison {
  Point start;
  Goal goal;
  std::uint64_t seed = 1;
  std::size_t runs = 1;
  std::vector<PlannerRuns> planners{};
  std::optional<Length> optimum{};  ///< of the plane; absent when no planner found a path
  bool is_shut = false;             ///< there is none: walls prove it
  double within = 0;                ///< path_bound of the space: how far proofs go

  /// The first planner that says its paths are the shortest gives the optimum.
  void add(PlannerRuns more);
  /// The first planner one of whose paths does not pass the check, if any: a defect.
  const PlannerRuns* wrong() const;
};

/// Why a planner had better not run there unless it is asked for by name; empty when it may: beyond 20 000 places a
/// full visibility graph may take all memory.
std::string too_large(const Planner& planner, const FreeSpace& space);

/// Runs a planner `runs` times with seeds seed, seed + 1, ... and the other wishes of `request`; once when it is not
/// random. A world that does not suit it is `unfit`.
PlannerRuns run_planner(const Planner& planner, const FreeSpace& space, Point from, const Goal& to, std::uint64_t seed,
                        std::size_t runs, const BuildRequest& request = {});

}  // namespace taut
