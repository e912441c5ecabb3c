#include <taut/robots/car/drivers.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace taut::car {

namespace {

constexpr std::array<std::string_view, 4> kNames{"ours", "optimist", "pessimist", "clairvoyant"};
constexpr double kNearCar = 2.0;  // more than half the car's diagonal and a step

/// What a driver takes for closed while it plans.
struct Belief {
  RoadblockSet open = 0;
  RoadblockSet closed = 0;
  RoadblockSet avoided = 0;  ///< unknown, taken for closed
  RoadblockSet shut() const { return closed | avoided; }
};

/// The first roadblock of a way that is not known to be open: after how many steps it is seen, and which.
struct Gamble {
  std::size_t steps = 0;
  RoadblockSet block = 0;
};

class PlannedDriver : public Driver {
 public:
  PlannedDriver(DriverKind kind, LatticePlanner& planner, RoadblockSet told)
      : kind_(kind), planner_(planner), told_(told) {}

  std::optional<double> next(const ObservedMap& map, const Pose& pose) override {
    if (!plan_ || at_ == plan_->controls.size() || must_replan(map)) choose(map, pose);
    return plan_ ? std::optional(plan_->controls[at_++]) : std::nullopt;
  }

  int replans() const override { return replans_; }

 private:
  bool must_replan(const ObservedMap& map) const {
    if (kind_ == DriverKind::clairvoyant) return false;
    const RoadblockSet news = (map.open() | map.closed()) & ~(belief_.open | belief_.closed);
    return (news & map.closed() & crossed_) != 0 || (news & map.open() & belief_.avoided) != 0;
  }

  void choose(const ObservedMap& map, const Pose& pose) {
    const bool again = plan_ != nullptr;
    belief_ = {map.open(), map.closed(), 0};
    if (kind_ == DriverKind::clairvoyant) belief_ = {told_, map.all() & ~told_, 0};
    if (kind_ == DriverKind::pessimist) belief_.avoided = map.unknown();
    if (kind_ == DriverKind::ours) value(map.course(), pose, belief_, kDeepest, &belief_.avoided);
    plan_ = planner_.plan(pose, belief_.shut());
    if (!plan_ && belief_.avoided != 0) {
      belief_.avoided = 0;
      plan_ = planner_.plan(pose, belief_.shut());
    }
    at_ = 0;
    crossed_ = plan_ ? crossed(map.course(), *plan_, map.unknown() & ~belief_.avoided) : 0;
    replans_ += again;
  }

  /// The roadblocks, of `which`, that the plan passes over.
  RoadblockSet crossed(const Course& course, const Plan& plan, RoadblockSet which) const {
    RoadblockSet found = 0;
    for (std::size_t i = 0; i < course.roadblocks.size(); ++i)
      if ((which >> i) & 1 && std::ranges::any_of(plan.poses, [&](const Pose& p) { return is_on(p, course, i); }))
        found |= RoadblockSet{1} << i;
    return found;
  }

  static bool is_on(const Pose& pose, const Course& course, std::size_t block) {
    return std::ranges::any_of(course.roadblocks[block].cells, [&](Cell c) {
      return std::hypot(c.x - pose.x, c.y - pose.y) < kNearCar + 1 && touches(pose, c, WallReading::squares, kForward);
    });
  }

  std::optional<Gamble> first_gamble(const Course& course, const Plan& plan, RoadblockSet open) const {
    const RoadblockSet all = (RoadblockSet{1} << course.roadblocks.size()) - 1;
    const RoadblockSet on_way = crossed(course, plan, all & ~open);
    if (on_way == 0) return std::nullopt;
    for (std::size_t k = 0; k < plan.poses.size(); ++k)
      if (const RoadblockSet seen = seen_from(plan.poses[k], course) & on_way) return Gamble{k + 1, seen & (~seen + 1)};
    return std::nullopt;
  }

  /// V of the header. `avoid`: what the better choice avoids from here.
  double value(const Course& course, const Pose& pose, const Belief& belief, int deep, RoadblockSet* avoid) {
    if (avoid) *avoid = belief.avoided;
    const Plan* plan = planner_.plan(pose, belief.shut());
    if (!plan) return kNoWay;
    const auto cost = static_cast<double>(plan->controls.size());
    const std::optional<Gamble> gamble = first_gamble(course, *plan, belief.open);
    if (!gamble || deep == 0) return cost;
    const double tried = value_of_trying(course, *plan, *gamble, belief, deep);
    if (tried <= cost) return tried;  // no detour is shorter than the way itself
    Belief other = belief;
    other.avoided |= gamble->block;
    RoadblockSet then = 0;
    const double avoided = value(course, pose, other, deep - 1, &then);
    if (avoid && avoided < tried) *avoid = then;
    return std::min(tried, avoided);
  }

  double value_of_trying(const Course& course, const Plan& plan, const Gamble& gamble, const Belief& belief, int deep) {
    const Pose& there = plan.poses[gamble.steps - 1];
    const auto which = static_cast<std::size_t>(std::countr_zero(gamble.block));
    const double p = course.roadblocks[which].open_probability;
    double expected = static_cast<double>(gamble.steps);
    Belief known = belief;
    if (p > 0) {
      known.open = belief.open | gamble.block;
      expected += p * value_when_open(course, plan, gamble, known, deep);
    }
    if (p < 1) {
      known = belief;
      known.closed |= gamble.block;
      expected += (1 - p) * value(course, there, known, deep - 1, nullptr);
    }
    return expected;
  }

  /// The way goes on, unless it meets a further roadblock that is unknown.
  double value_when_open(const Course& course, const Plan& plan, const Gamble& gamble, const Belief& known, int deep) {
    if (!first_gamble(course, plan, known.open)) return static_cast<double>(plan.controls.size() - gamble.steps);
    return value(course, plan.poses[gamble.steps - 1], known, deep - 1, nullptr);
  }

  DriverKind kind_;
  LatticePlanner& planner_;
  RoadblockSet told_;
  const Plan* plan_ = nullptr;
  std::size_t at_ = 0;
  Belief belief_;
  RoadblockSet crossed_ = 0;  ///< unknown when planned, on the way
  int replans_ = 0;
};

}  // namespace

std::string_view name(DriverKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<DriverKind> driver_named(std::string_view word) {
  const auto at = std::ranges::find(kNames, word);
  if (at == kNames.end()) return std::nullopt;
  return static_cast<DriverKind>(at - kNames.begin());
}

std::unique_ptr<Driver> make_driver(DriverKind kind, LatticePlanner& planner, RoadblockSet told) {
  return std::make_unique<PlannedDriver>(kind, planner, told);
}

}  // namespace taut::car
