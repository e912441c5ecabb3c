// The question of a chase and its answers: where the target can be met, and the pursuer's way there.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include <taut/robots/pursuit/chase_map.h>
#include <taut/search/search_status.h>

namespace taut::pursuit {

/// The two scoring programs differ by one second: the cell after t moves is compared with the entry counted t from 0, t
/// >= 1, or from 1.
enum class Clock { zero, one };

/// The target is in `cell`, a free one, at `second`, counted from the robot's start.
struct Meeting {
  CellIndex cell = 0;
  int second = 0;

  friend bool operator==(const Meeting&, const Meeting&) = default;
};

/// All meetings of a map by ascending second, one a second at most: entries in obstacles are none, nor is the one at
/// the very start.
std::vector<Meeting> meetings_of(const ChaseMap& map, Clock clock);

/// Somebody in `from` at second `now` who wants to be at one of `meetings` in time, at the least cost.
struct Chase {
  const ChaseMap* map = nullptr;
  CellIndex from = 0;  ///< free
  int now = 0;
  std::vector<Meeting> meetings;  ///< ascending, those up to `now` do not count
};

/// The whole map from its start.
Chase chase_of(const ChaseMap& map, Clock clock);

/// A way: `cells[i]` is where one is at second `now + i`, the first is `from`, the last a meeting, and no earlier one
/// is.
struct ChasePlan {
  SearchStatus status = SearchStatus::none;
  bool optimal = false;          ///< proven: no way costs less
  Cost cost = 0;                 ///< sum of the costs of all cells but the last, in units
  std::vector<CellIndex> cells;  ///< when found
  Cost bound = 0;                ///< no way costs less; equal to cost when optimal
  std::string reason;            ///< when none or stopped
};

/// What a plan took.
struct PlanEffort {
  std::size_t searches = 0;  ///< Dijkstra's algorithm over the map
  std::size_t expanded = 0;  ///< cells and labels taken from queues
  std::size_t labels = 0;    ///< of a search with two criteria, where seconds are scarce
};

/// How long to go on.
struct PlanLimits {
  double seconds = 0;                    ///< 0: as long as it takes. A first plan may come later
  std::size_t most_labels = 30'000'000;  ///< about 50 bytes each at worst
  std::function<bool()> stopped{};       ///< asked every few thousand steps; with jobs from two threads at once
  /// Called with each plan that is better than the one before, proven or not, and again when its bound is.
  std::function<void(const ChasePlan&)> better{};
  unsigned jobs = 1;  ///< threads that the exact planner may take on large maps: it has work for two
};

/// Why nobody can meet the target, for ChasePlan::reason: the trajectory lies in obstacles, apart from the robot, or
/// ends too soon.
std::string reason_of_failure(const Chase& chase);

/// An independent check. Empty when `plan` is a legal way that keeps what ChasePlan says (but optimality), else what is
/// wrong.
std::string verify_plan(const ChasePlan& plan, const Chase& chase);

}  // namespace taut::pursuit
