// What `taut compare` lets run. A further planner is one more row in planners.cpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <taut/cli/solve/roadmap_kinds.h>

namespace taut::cli {

/// A roadmap and how it is searched.
struct Planner {
  const char* name;  ///< in tables and in --planners
  const char* kind;  ///< of roadmap_kinds()
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
  double build_seconds = 0;
  double query_seconds = 0;
  std::size_t expanded = 0;
  std::shared_ptr<const Roadmap> roadmap{};
};

/// All runs of one planner.
struct PlannerRuns {
  const Planner* planner = nullptr;
  bool optimal = false;          ///< RoadmapKind::optimal
  std::vector<PlannerRun> runs;  ///< one each seed, or one
  std::string unfit{};           ///< why it did not run at all, then `runs` is empty

  std::size_t solved() const;
  /// The one that stands for all: the median of those solved by length, or the first when none is.
  const PlannerRun& typical() const;
  /// The median over all runs of one of their numbers, the upper of the two in the middle.
  double median(double (*number)(const PlannerRun&)) const;
};

/// Runs a planner `runs` times with seeds seed, seed + 1, ... and the other wishes of `request`; once when it is not
/// random. A world that does not suit it is `unfit`.
PlannerRuns run_planner(const Planner& planner, const FreeSpace& space, Point from, const Goal& to, std::uint64_t seed,
                        std::size_t runs, const BuildRequest& request = {});

}  // namespace taut::cli
