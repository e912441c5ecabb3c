// One chase, asked for and played: a planner, or somebody who sees the target second by second, on a map by a clock.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <taut/robots/pursuit/chase.h>

namespace taut::pursuit {

/// Who can be asked to chase: a planner whose plans are followed, or somebody who heads for where the target will be.
struct NamedPursuer {
  std::string_view name;
  std::string_view description;
  const NamedPlanner* planner = nullptr;
  std::optional<int> ahead{};  ///< of a HeadingPursuer
};

/// The planners, `ahead` and `fixed`.
std::span<const NamedPursuer> chase_pursuers();
const NamedPursuer* chase_pursuer(std::string_view name);  ///< null when there is none of that name

/// How it is played.
struct ChaseRequest {
  const NamedPlanner* planner = nullptr;
  Clock clock = Clock::zero;
  bool free_planning = false;
  double plan_seconds = 0;     ///< a call of the planner; 0: no limit
  std::optional<int> horizon;  ///< online: the seconds of the trajectory that are seen ahead; nobody plans on all of it
  std::optional<int> ahead;    ///< heading: a HeadingPursuer moves, nobody plans
  std::uint32_t weight = 3;    ///< of the planner `weighted`, 1 to 1000
  unsigned jobs = 1;           ///< PlanLimits::jobs

  /// The planner's; `online`, `ahead` or, where it heads for the end, `fixed`.
  std::string_view planner_name() const;

  PlanLimits limits() const;
};

/// What came of it.
struct ChaseRun {
  ChaseRequest request;
  ChaseResult result;
  ChasePlan plan;  ///< the first; when online what somebody would do who knows it all: `exact`; when heading none
  PlanEffort effort;
  int plans = 0;
  double seconds_ahead = 0;  ///< of planning while the robot moved
  std::string fault;         ///< of a plan as verify_plan() sees it, or of a step; a defect of the planner

  bool is_caught() const { return result.end == ChaseEnd::caught; }
  /// Nobody catches it for less: the plan is proven, and it was kept.
  bool is_proven(const ChaseMap& map) const;
  /// Nobody catches it at all.
  bool is_hopeless() const { return plan.status == SearchStatus::none && !is_caught(); }
  std::string why_not() const;  ///< when not caught
  /// When online and caught: the cost in parts of that of `plan`.
  std::optional<double> ratio() const;
};

/// Plays the request. `better` is told of each better plan for the whole chase, see PlanLimits, and is kept no longer
/// than the call.
ChaseRun run_chase(const ChaseMap& map, const ChaseRequest& request,
                   const std::function<void(const ChasePlan&)>& better = {});

/// `zero` or `one`
std::string_view name(Clock clock);

}  // namespace taut::pursuit
