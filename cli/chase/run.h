// One chase: a planner on a map by a clock.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>

#include <taut/robots/pursuit/chase.h>

namespace taut::cli {

/// How it is played.
struct ChaseRequest {
  const pursuit::NamedPlanner* planner = nullptr;
  pursuit::Clock clock = pursuit::Clock::zero;
  bool free_planning = false;
  double plan_seconds = 0;     ///< a call of the planner; 0: no limit
  std::optional<int> horizon;  ///< online: the seconds of the trajectory that are seen ahead; nobody plans on all of it

  std::string_view planner_name() const { return horizon ? "online" : planner->name; }

  pursuit::PlanLimits limits() const;
};

struct ChaseRun {
  ChaseRequest request;
  pursuit::ChaseResult result;
  pursuit::Plan plan;  ///< the first; when online what somebody would do who knows it all: `exact`
  pursuit::PlanEffort effort;
  int plans = 0;
  double seconds_ahead = 0;  ///< of planning while the robot moved
  std::string fault;         ///< of a plan, as its check sees it; a defect of the program

  bool is_caught() const { return result.end == pursuit::ChaseEnd::caught; }
  /// Nobody catches it for less: the plan is proven, and it was kept.
  bool is_proven(const pursuit::ChaseMap& map) const;
  /// Nobody catches it at all.
  bool is_hopeless() const { return plan.status == pursuit::PlanStatus::none && !is_caught(); }
  int exit_code() const;
  std::string why_not() const;  ///< when not caught
  /// When online and caught: the cost in parts of that of `plan`.
  std::optional<double> ratio() const;
};

/// `better` is told of each better plan for the whole chase; see PlanLimits.
ChaseRun run_chase(const pursuit::ChaseMap& map, const ChaseRequest& request,
                   const std::function<void(const pursuit::Plan&)>& better = {});

/// `zero` or `one`
std::string_view name(pursuit::Clock clock);

/// The report's four columns under their heads, and a line before them that says what is proven.
std::string chase_text(const pursuit::ChaseMap& map, const ChaseRun& run);

/// `x,y` at each second that a step ends, a line each: `0 119,45`.
std::string track_text(const pursuit::ChaseMap& map, const ChaseRun& run);

/// `file`, `status` (`found`, `none`, `stopped`), `planner` (`online`), `clock`, `free_planning`, `caught`, `time`,
/// `moves`, `cost`, `proven`, `lower_bound`, `reason`, `planning`, `peak_memory_bytes`, `path` of [second, x, y]; when
/// online `online`: `horizon`,
/// `clairvoyant_cost`, `ratio`.
nlohmann::ordered_json chase_json(const pursuit::ChaseMap& map, const ChaseRun& run);

}  // namespace taut::cli
