// A pursuer who does not know where the target will go.
#pragma once

#include <optional>
#include <vector>

#include <taut/robots/pursuit/pursuit.h>

namespace taut::pursuit {

/// What is known of the target at one second: where it is, and for how many seconds on.
struct TargetSighting {
  int now = 0;
  std::vector<Meeting> seen;  ///< from `now` to the horizon, ascending, also in obstacles
};

/// Unfolds a trajectory second by second, each with the `horizon` seconds that follow.
class Unfolding {
 public:
  /// The map is kept by reference. Precondition: horizon >= 0.
  Unfolding(const ChaseMap& map, Clock clock, int horizon);

  /// Empty when the target has gone, and by clock one at second 0 without a horizon.
  TargetSighting at(int now) const;

 private:
  const ChaseMap& map_;
  int first_;  // second of the first entry
  int horizon_;
};

/// Chases what it sees.
///
///  1. What it knows is the ground and the sights it was given: the constructor takes a map that has no trajectory
///     (ChaseMap::without_trajectory).
///  2. As soon as a meeting that it has seen can be reached in time, it follows the exact plan to the cheapest such
///     meeting. It looks for a cheaper one among later sights whenever a sixteenth of the time to the meeting has
///     passed, unless the second alone makes all new ones dearer.
///  3. Else it expects the target to go on in the direction of its last step until something is in the way, and to stay
///     there; it heads for the first cell of that line where it could, without obstacles, be in time, along a way of
///     least cost. When the target did otherwise it plans again, but not before a sixteenth of the way has passed: each
///     second once it is near.
///  4. While it sees no free cell of the target, it goes on to where it last expected it, then waits.
///  5. Each step is legal. With a horizon that shows the whole trajectory at second 0 it costs what exact_plan costs.
///
/// A decision takes O(cells log cost) at worst, in most seconds O(1). Nothing is promised about the cost: a target that
/// never turns is never caught from behind.
class OnlinePursuer {
 public:
  /// The ground is kept by reference. `limits` hold for each exact plan.
  explicit OnlinePursuer(const ChaseMap& ground, PlanLimits limits = {});

  CellIndex next(CellIndex at, const TargetSighting& sight);

  int plans() const { return plans_; }  ///< exact ones and ways of least cost

 private:
  bool is_on_way(CellIndex at, int now) const;
  CellIndex follow(int now) const { return way_[static_cast<std::size_t>(now - begin_) + 1]; }
  void look_for_meeting(CellIndex at, const TargetSighting& sight);
  bool could_be_cheaper(const TargetSighting& sight) const;
  void head_for_target(CellIndex at, const TargetSighting& sight);
  CellIndex expected(CellIndex at, const TargetSighting& sight);
  void set_way(std::vector<CellIndex> way, int now, bool is_sure);

  const ChaseMap& ground_;
  PlanLimits limits_;
  std::uint32_t cheapest_;      // of all cells
  std::vector<CellIndex> way_;  // from second begin_ on
  int begin_ = 0;
  int due_ = 0;           // when to plan anew
  bool is_sure_ = false;  // the way ends at a meeting that was seen
  int known_ = -1;        // the last second that the way takes into account
  std::optional<CellIndex> last_seen_;
  std::optional<CellIndex> expected_;
  int plans_ = 0;
};

}  // namespace taut::pursuit
