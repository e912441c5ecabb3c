// Decisions where there are too many roadblocks to think all outcomes through.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <taut/robots/roadblocks/roadblock_policy.h>

namespace taut::roadblocks {

/// Decides as RoadblockPolicy does, by simulated drives between doors (doors.h) instead of all outcomes.
///
///  1. Once for a course: places at both sides of every door and the estimated steps between them. A state is where the
///     car is, and which doors are open, closed and unknown.
///  2. A decision is which unknown door to go and see, from which side, or to go to the goal through what is open. Each
///     that might be better than the last is valued by simulated drives in kWorlds random worlds that have a way, the
///     same for all: optimistic rollouts (Eyerich, Keller, Helmert, "High-quality policies for the Canadian traveler's
///     problem", 2010), where the drive after the first sight is the best of a family that takes unknown doors for open
///     at a price, from none (the optimist) to infinite (the pessimist), chosen by what is seen first. So no choice
///     looks worse than the optimist's or the pessimist's; the optimist's is left only for one 3 % better. A door of
///     several roadblocks that is closed also costs the way to the one that is, and out again.
///  3. One plan of the planner's a decision: the optimist's where it is what was chosen, else one around all doors that
///     the choice does not pass; its rest is kept as long as that stays so. Where no plan is found that way, and where
///     the places know no way, the optimist's. Where one roadblock of a door is closed, plans go around all of it.
///  4. Every sight of a roadblock makes a new decision. Those met before, in other drives too, are looked up.
///  5. Worlds are drawn from a fixed seed by the roadblocks' probabilities: same questions, same answers. Choice::value
///     is an estimate, and Choice::exact false.
/// `Aim::worst` takes the longest of the simulated drives instead of their mean. Memory: the tables between doors (some
/// 0.3 MB for each side of a door on 50 x 50), 30 MB for what is kept, and the planner's.
class RolloutPolicy {
 public:
  static constexpr std::size_t kWorlds = 200;

  /// How choices are valued: as above, or, to compare with, by a search tree over beliefs (UCT) whose leaves are
  /// rollouts of the optimist: it minds neither `aim` nor what estimates may be wrong by.
  enum class Look : std::uint8_t { rollouts, uct };

  /// `planner` must outlive it.
  RolloutPolicy(LatticePlanner& planner, Aim aim, Look look = Look::rollouts);
  ~RolloutPolicy();
  RolloutPolicy(const RolloutPolicy&) = delete;
  RolloutPolicy& operator=(const RolloutPolicy&) = delete;

  RoadblockPolicy::Choice choose(const Pose& from, RoadblockSet open, RoadblockSet closed);

  /// What the optimist does, whose plans are kept in the same way, and serve whichever roadblock of a door is closed.
  RoadblockPolicy::Choice hope(const Pose& from, RoadblockSet open, RoadblockSet closed);

  /// What the pessimist does: unknown roadblocks count as closed while the estimate knows a way so, else as open.
  RoadblockPolicy::Choice fear(const Pose& from, RoadblockSet open, RoadblockSet closed);

  /// The open roadblocks of those of the random worlds number `begin` to `end` (exclusive) that have a way by the
  /// places, from the course's start. No decision is made by these.
  std::vector<RoadblockSet> worlds(std::size_t begin, std::size_t end);

  /// Of doors by which the goal might be reached sooner than without any that is unknown; all that can be reached where
  /// there is no such way. By estimates, from the course's start.
  RoadblockSet relevant();

  /// Null when the tables between doors would need more bytes.
  static std::unique_ptr<RolloutPolicy> within(LatticePlanner& planner, Aim aim, std::size_t bytes);

  std::size_t decisions() const;  ///< made, not looked up

 private:
  struct Impl;
  explicit RolloutPolicy(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut::roadblocks
