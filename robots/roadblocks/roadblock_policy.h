// Which way to try first: the Canadian traveller problem of a car among roadblocks.
#pragma once

#include <cstddef>
#include <memory>

#include <taut/robots/roadblocks/lattice_planner.h>

namespace taut::roadblocks {

/// What a policy makes least.
enum class Aim : std::uint8_t {
  /// the steps to be expected, roadblocks being open independently with their probabilities (1/2 where the file has
  /// none)
  expected,
  worst  ///< the steps of the worst outcome; probabilities do not matter, but for 0 and 1
};

/// Decides by what may be learnt. A decision is due at the start and whenever a roadblock's state has shown. The ways
/// to choose from are the planner's ways that avoid a set of unknown roadblocks, for every such set that makes a
/// difference; a way is followed until a relevant unknown roadblock comes into sight, on the way or beside it, and then
///
///     V(pose, open, closed) = min over ways of (steps + the mean, or the maximum, over what is seen there of V(there,
///     open', closed'))
///
///  1. Exact on the graph that these ways and places make: all information states that can come up are solved, with
///     branch and bound and a table, to the last roadblock, as long as the planner does not search more than `searches`
///     times for one choice, nor expands 1000 times as many states (a fifth of both once the planner has searched 400
///     times in all). After that a state counts what it costs with unknown roadblocks open, and Choice::exact is false;
///     the drive decides again, with the same budget, at its next sight. What the graph holds depends on what was
///     looked at: ways found on the way serve later places, and bounds leave ways out. Without any bound the value came
///     out lower by up to 2.4 % (in 2 of 3 mazes with 8 roadblocks; the third was not finished).
///  2. Relevant roadblocks are those that any of these ways crosses; seeing another decides nothing and makes no
///     information state. A way that crosses no unknown one is not left.
///  3. Not considered: driving somewhere for a look that is on no such way.
///  4. Values are kept promises: when exact, the mean (maximum) over all outcomes of the steps driven is the value at
///     the start, to the step.
///  5. An outcome in which there is no way from the start either costs what is driven until that is known. One in which
///     there is none from where the car is by then costs kStranded more, so that such risks are taken only where every
///     way has them.
class RoadblockPolicy {
 public:
  RoadblockPolicy(LatticePlanner& planner, Aim aim, std::size_t searches = 400);  ///< `planner` must outlive it
  ~RoadblockPolicy();
  RoadblockPolicy(const RoadblockPolicy&) = delete;
  RoadblockPolicy& operator=(const RoadblockPolicy&) = delete;

  struct Choice {
    const DrivePlan* plan = nullptr;  ///< to the goal; to be left at its first sight. Null: no way, whatever is open
    double value = 0;                 ///< steps
    bool exact = true;
    RoadblockSet relevant = 0;  ///< roadblocks whose sight calls for a new choice
  };

  Choice choose(const Pose& from, RoadblockSet open, RoadblockSet closed);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

inline constexpr double kStranded = 1e7;

}  // namespace taut::roadblocks
