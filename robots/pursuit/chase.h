// A chase second by second, as scoring programs run it, and somebody who follows a planner's plans.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <taut/robots/pursuit/pursuit.h>

namespace taut::pursuit {

/// What is counted, and how.
struct ChaseRules {
  Clock clock = Clock::zero;
  bool free_planning = false;         ///< each move takes one second, however long it was thought about
  std::function<double()> seconds{};  ///< a clock for the thinking; empty: the wall's
};

/// Where the robot goes next from `at` at second `now`: a neighbour or `at` itself; nothing: it gives up.
using NextMove = std::function<std::optional<CellIndex>(CellIndex at, int now)>;

/// How a chase ended.
enum class ChaseEnd {
  caught,
  escaped,  ///< the trajectory ended
  gave_up,
  illegal,  ///< a move to a cell that is no neighbour, no cell, or an obstacle
};

/// One move: after it the robot is in `cell` at `second`.
struct ChaseStep {
  CellIndex cell = 0;
  int second = 0;

  friend bool operator==(const ChaseStep&, const ChaseStep&) = default;
};

/// What came of a chase.
struct ChaseResult {
  ChaseEnd end = ChaseEnd::gave_up;
  int time = 0;                  ///< seconds passed
  int moves = 0;                 ///< to another cell; waiting is none
  Cost cost = 0;                 ///< in units
  std::vector<ChaseStep> track;  ///< the start at second 0, then each step
  double first_thought = 0;      ///< seconds until the first move was known
  double longest_thought = 0;
  std::string reason;  ///< when illegal
};

/// Plays until an end.
///
///  1. A step takes one second, or the whole seconds that thinking took, rounded up, if more (unless planning is free).
///     It costs (seconds) x (cost of the cell that is left).
///  2. Caught: at the end of a step the robot is where the target is at that second. The seconds within a long step do
///     not count.
///  3. A step that ends after the last meeting's second still counts; then the target has escaped, as it has at once
///     when there is no meeting at all.
///  4. An illegal step ends the chase and is neither counted nor tracked; `reason` names it.
ChaseResult play(const ChaseMap& map, const ChaseRules& rules, const NextMove& next_move);

/// Anything that plans.
using PlanFunction = std::function<ChasePlan(const Chase&, const PlanLimits&, PlanEffort*)>;

/// A planner as the program offers it.
struct NamedPlanner {
  std::string_view name;
  std::string_view description;
  ChasePlan (*plan)(const Chase&, const PlanLimits&, PlanEffort*);
};

/// `exact`, `entry`, `weighted` (entry with weight 3), `first`.
std::span<const NamedPlanner> chase_planners();
const NamedPlanner* chase_planner(std::string_view name);  ///< null when there is none of that name

/// Plans when there is no plan, and goes along it. When a step took longer than the plan has it, first gives up as much
/// waiting as it needs to be in time; plans again when there is not enough, then for the second at which it expects to
/// be ready.
///
/// With a clock it thinks while it moves: as long as its plan is not proven it plans ahead, for the cell and the second
/// where the plan will have led it 2 seconds later, then 6, then 18, in so many times `limits.seconds`. It changes to
/// that plan there if the rest costs less than the old plan's, and if it was ready by then. No more than that: what so
/// much time does not prove rarely becomes better.
class Follower {
 public:
  /// The map is kept by reference. `limits` hold for each call of the planner. `seconds`: a clock for the thinking.
  Follower(const ChaseMap& map, Clock clock, PlanFunction planner, PlanLimits limits = {},
           std::function<double()> seconds = {});

  std::optional<CellIndex> next(CellIndex at, int now);

  const ChasePlan& first_plan() const { return first_; }  ///< as the planner gave it
  int plans() const { return plans_; }                    ///< calls of the planner
  /// Of thinking ahead: it took place while the robot moved, so a clock for ChaseRules should leave it out.
  double seconds_ahead() const { return seconds_ahead_; }

 private:
  /// What was thought of a later second.
  struct Ahead {
    Chase chase;
    ChasePlan plan;
  };

  bool is_on_plan(CellIndex at, int now) const;
  bool catch_up(CellIndex at, int now);
  void plan_anew(CellIndex at, int now);
  void plan_ahead(int now);
  void adopt(CellIndex at, int now);
  ChasePlan planned(const Chase& chase, const PlanLimits& limits, double& taken);

  Chase chase_;
  PlanFunction planner_;
  PlanLimits limits_;
  std::function<double()> seconds_;
  ChasePlan plan_;
  ChasePlan first_;
  std::size_t done_ = 0;  // of plan_.cells
  int plans_ = 0;
  int delay_ = 0;  // that the next plan anew allows for
  std::optional<Ahead> ahead_;
  int look_ahead_;  // seconds; 0: no more
  double seconds_ahead_ = 0;
};

}  // namespace taut::pursuit
