#include <taut/robots/roadblocks/drivers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace taut::roadblocks {

namespace {

constexpr std::array<std::string_view, 4> kNames{"policy", "optimist", "pessimist", "clairvoyant"};

/// A plan and how far it has been followed.
class PlannedDriver : public Driver {
 public:
  explicit PlannedDriver(LatticePlanner& planner) : planner_(planner) {}

  std::optional<double> next(const ObservedMap& map, const Pose& pose) override {
    const RoadblockSet news = map.unknown() ^ unknown_;
    if (!plan_ || at_ == plan_->controls.size() || must_decide(map, news)) follow(decided(map, pose));
    unknown_ = map.unknown();
    if (!plan_) gave_up_ = planner_.gave_up(pose, assumed_closed(map));
    return plan_ ? std::optional(plan_->controls[at_++]) : std::nullopt;
  }

  int replans() const override { return replans_; }
  bool gave_up() const override { return gave_up_; }

 protected:
  virtual bool must_decide(const ObservedMap& map, RoadblockSet news) const = 0;
  virtual const DrivePlan* decided(const ObservedMap& map, const Pose& pose) = 0;
  virtual RoadblockSet assumed_closed(const ObservedMap& map) const { return map.closed(); }
  LatticePlanner& planner() const { return planner_; }

 private:
  /// What goes on as before is no new plan.
  void follow(const DrivePlan* plan) {
    if (plan_ &&
        !(plan && std::equal(plan->controls.begin(), plan->controls.end(),
                             plan_->controls.begin() + static_cast<std::ptrdiff_t>(at_), plan_->controls.end())))
      ++replans_;
    plan_ = plan;
    at_ = 0;
  }

  LatticePlanner& planner_;
  const DrivePlan* plan_ = nullptr;
  std::size_t at_ = 0;
  RoadblockSet unknown_ = 0;
  int replans_ = 0;
  bool gave_up_ = false;
};

class PolicyDriver : public PlannedDriver {
 public:
  PolicyDriver(DrivePolicy& policy, LatticePlanner& planner) : PlannedDriver(planner), policy_(policy) {
    policy_.begin_drive();
  }
  PolicyDriver(std::unique_ptr<DrivePolicy> policy, LatticePlanner& planner) : PolicyDriver(*policy, planner) {
    own_ = std::move(policy);
  }

  bool exact() const override { return exact_; }

 protected:
  bool must_decide(const ObservedMap&, RoadblockSet news) const override { return (news & choice_.relevant) != 0; }
  const DrivePlan* decided(const ObservedMap& map, const Pose& pose) override {
    choice_ = policy_.choose(pose, map.open(), map.closed());
    exact_ = exact_ && choice_.exact;
    return choice_.plan;
  }

 private:
  std::unique_ptr<DrivePolicy> own_;
  DrivePolicy& policy_;
  RoadblockPolicy::Choice choice_;
  bool exact_ = true;
};

/// Takes what is unknown for open (optimist), for closed (pessimist), or for what it was told (clairvoyant).
class BelievingDriver : public PlannedDriver {
 public:
  BelievingDriver(DriverKind kind, LatticePlanner& planner, RoadblockSet told)
      : PlannedDriver(planner), kind_(kind), told_(told) {}

 protected:
  bool must_decide(const ObservedMap& map, RoadblockSet news) const override {
    if (kind_ == DriverKind::clairvoyant) return false;
    return (news & map.closed() & crossed_) != 0 || (news & map.open() & avoided_) != 0;
  }

  RoadblockSet assumed_closed(const ObservedMap& map) const override {
    return kind_ == DriverKind::clairvoyant ? map.all() & ~told_ : map.closed();
  }

  const DrivePlan* decided(const ObservedMap& map, const Pose& pose) override {
    const RoadblockSet closed = assumed_closed(map);
    avoided_ = kind_ == DriverKind::pessimist ? map.unknown() : 0;
    const DrivePlan* plan = planner().plan(pose, closed | avoided_);
    if (!plan && avoided_ != 0) {
      avoided_ = 0;
      plan = planner().plan(pose, closed);
    }
    crossed_ = plan ? crossed(map.course(), pose, *plan) : 0;
    return plan;
  }

 private:
  RoadblockSet crossed(const Course& course, const Pose& from, const DrivePlan& plan) const {
    RoadblockSet found = 0;
    for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
      if (crosses(from, plan, course.roadblocks[b], planner().reading())) found |= RoadblockSet{1} << b;
    return found;
  }

  DriverKind kind_;
  RoadblockSet told_;
  RoadblockSet avoided_ = 0;
  RoadblockSet crossed_ = 0;
};

}  // namespace

std::string_view name(DriverKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<DriverKind> driver_named(std::string_view word) {
  const auto at = std::ranges::find(kNames, word);
  if (at == kNames.end()) return std::nullopt;
  return static_cast<DriverKind>(at - kNames.begin());
}

std::unique_ptr<Driver> make_driver(DriverKind kind, LatticePlanner& planner, RoadblockSet told, Aim aim) {
  if (kind == DriverKind::policy)
    return std::make_unique<PolicyDriver>(std::make_unique<DrivePolicy>(planner, aim), planner);
  return std::make_unique<BelievingDriver>(kind, planner, told);
}

std::unique_ptr<Driver> make_driver(DrivePolicy& policy, LatticePlanner& planner) {
  return std::make_unique<PolicyDriver>(policy, planner);
}

}  // namespace taut::roadblocks
