#include <taut/robots/roadblocks/drive_policy.h>

#include <bit>

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

RoadblockPolicy::Choice DrivePolicy::choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
  if (exact_) {
    const RoadblockPolicy::Choice choice = exact_->choose(from, open, closed);
    if (choice.exact || !rollouts_) return choice;
    exact_.reset();
  }
  return rollouts_->choose(from, open, closed);
}

}  // namespace taut::roadblocks
