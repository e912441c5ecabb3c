#include <taut/robots/roadblocks/drive_policy.h>

#include <bit>

#include <taut/robots/roadblocks/detail/trials.h>

namespace taut::roadblocks {

DrivePolicy::DrivePolicy(LatticePlanner& planner, Aim aim) : planner_(planner), aim_(aim) {
  if (planner.course().roadblocks.size() > kExactRoadblocks)
    rollouts_ = RolloutPolicy::within(planner, aim, kMostBytes);
  if (!rollouts_)
    begin_drive();
  else if (static_cast<std::size_t>(std::popcount(rollouts_->relevant())) <= kExactRoadblocks)
    exact_ = std::make_unique<RoadblockPolicy>(planner, aim, kSearches);
}

DrivePolicy::~DrivePolicy() = default;

void DrivePolicy::begin_drive() {
  if (!rollouts_) exact_ = std::make_unique<RoadblockPolicy>(planner_, aim_);
}

void DrivePolicy::judge() {
  is_judged_ = true;
  switch (detail::best_whole(planner_, *rollouts_, aim_)) {
    case detail::Whole::hope: decide_ = &RolloutPolicy::hope; break;
    case detail::Whole::fear: decide_ = &RolloutPolicy::fear; break;
    case detail::Whole::choose: decide_ = &RolloutPolicy::choose; break;
  }
}

RoadblockPolicy::Choice DrivePolicy::choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
  if (exact_) {
    const RoadblockPolicy::Choice choice = exact_->choose(from, open, closed);
    if (choice.exact || !rollouts_) return choice;
    exact_.reset();
  }
  if (!is_judged_) judge();
  return (*rollouts_.*decide_)(from, open, closed);
}

}  // namespace taut::roadblocks
