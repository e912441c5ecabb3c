#include <taut/robots/roadblocks/drive_policy.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

namespace taut::roadblocks {

namespace {

using Choice = RoadblockPolicy::Choice;
using Choose = std::function<Choice(const Pose&, RoadblockSet open, RoadblockSet closed)>;

/// Chooses again at every sight.
class TrialDriver : public Driver {
 public:
  explicit TrialDriver(const Choose& choose) : choose_(choose) {}
  std::optional<double> next(const ObservedMap& map, const Pose& pose) override {
    if (!plan_ || map.unknown() != unknown_) {
      plan_ = choose_(pose, map.open(), map.closed()).plan;
      unknown_ = map.unknown();
      at_ = 0;
    }
    return plan_ ? std::optional(plan_->controls[at_++]) : std::nullopt;
  }
  int replans() const override { return 0; }

 private:
  const Choose& choose_;
  const DrivePlan* plan_ = nullptr;
  RoadblockSet unknown_ = 0;
  std::size_t at_ = 0;
};

/// Steps in each world where the goal is reached: all and most.
std::pair<std::size_t, std::size_t> driven(const LatticePlanner& planner, const std::vector<RoadblockSet>& worlds,
                                           const Choose& choose) {
  std::pair<std::size_t, std::size_t> steps{0, 0};
  for (const RoadblockSet open : worlds) {
    TrialDriver driver(choose);
    const Drive run = drive(planner.course(), open, driver, planner.reading());
    if (run.outcome != Outcome::reached) continue;
    steps.first += run.controls.size();
    steps.second = std::max(steps.second, run.controls.size());
  }
  return steps;
}

}  // namespace

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
  const std::vector<RoadblockSet> worlds = rollouts_->worlds(kTrials);
  const auto by = [&](auto choose) {
    return driven(planner_, worlds, [this, choose](const Pose& from, RoadblockSet open, RoadblockSet closed) {
      return (*rollouts_.*choose)(from, open, closed);
    });
  };
  const auto [chosen, chosen_most] = by(&RolloutPolicy::choose);
  const auto [hoped, hoped_most] = by(&RolloutPolicy::hope);
  hopes_ = aim_ == Aim::expected ? hoped < chosen : std::pair(hoped_most, hoped) < std::pair(chosen_most, chosen);
}

RoadblockPolicy::Choice DrivePolicy::choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
  if (exact_) {
    const RoadblockPolicy::Choice choice = exact_->choose(from, open, closed);
    if (choice.exact || !rollouts_) return choice;
    exact_.reset();
  }
  if (!is_judged_) judge();
  return hopes_ ? rollouts_->hope(from, open, closed) : rollouts_->choose(from, open, closed);
}

}  // namespace taut::roadblocks
