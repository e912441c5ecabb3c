// The policy of all drives on one course: exact where that ends, by simulated drives where it does not.
#pragma once

#include <cstddef>
#include <memory>

#include <taut/robots/roadblocks/rollout_policy.h>

namespace taut::roadblocks {

/// Decides for any number of drives on one course and keeps for all of them what they share.
///
///  1. Up to kExactRoadblocks roadblocks: RoadblockPolicy, anew for each drive, so that a sample drives the same alone
///     and among others.
///  2. More of them, but at most as many that can matter (RolloutPolicy::relevant): one RoadblockPolicy for all drives.
///     With its first choice that is not exact, after kSearches searches, it ends for good, and 3. begins.
///  3. Else one RolloutPolicy for all drives: what it decided and estimated serves every later drive; no budget starts
///     again.
///     First it is judged (detail/trials.h): it, the optimist and the pessimist are driven from end to end, with real
///     plans, in 200 random worlds, and as many more as it takes, which no decision is made by. The better of optimist
///     and pessimist is followed for good unless the rollouts' choices need fewer steps by two standard errors of what
///     the drives among 200 worlds that have a way need in the mean (Aim::worst: no more in the worst of any quarter of
///     them). For estimates may mislead, and what is gained in the mean of so many worlds that few drives show it is
///     not worth a drive that is longer.
///  4. A course whose doors need more than kMostBytes of tables has RoadblockPolicy.
class DrivePolicy {
 public:
  DrivePolicy(LatticePlanner& planner, Aim aim);  ///< `planner` must outlive it
  ~DrivePolicy();
  DrivePolicy(const DrivePolicy&) = delete;
  DrivePolicy& operator=(const DrivePolicy&) = delete;

  void begin_drive();
  RoadblockPolicy::Choice choose(const Pose& from, RoadblockSet open, RoadblockSet closed);

  static constexpr std::size_t kExactRoadblocks = 8;
  static constexpr std::size_t kSearches = 100;
  static constexpr std::size_t kMostBytes = 200'000'000;

 private:
  void judge();

  LatticePlanner& planner_;
  Aim aim_;
  std::unique_ptr<RolloutPolicy> rollouts_;
  std::unique_ptr<RoadblockPolicy> exact_;
  bool is_judged_ = false;
  RoadblockPolicy::Choice (RolloutPolicy::*decide_)(const Pose&, RoadblockSet, RoadblockSet) = nullptr;
};

}  // namespace taut::roadblocks
