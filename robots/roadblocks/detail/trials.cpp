#include <taut/robots/roadblocks/detail/trials.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include <taut/robots/roadblocks/drivers.h>

namespace taut::roadblocks::detail {

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

double sum(std::span<const double> steps) { return std::accumulate(steps.begin(), steps.end(), 0.0); }
double most(std::span<const double> steps) { return steps.empty() ? 0 : *std::ranges::max_element(steps); }

/// By how many standard errors of the mean of `count` differences `bold` is less.
double errors_less(std::span<const double> bold, std::span<const double> base, std::size_t count) {
  const double n = std::max(static_cast<double>(bold.size()), 1.0);
  const double mean = (sum(base) - sum(bold)) / n;
  double squares = 0;
  for (std::size_t k = 0; k < bold.size(); ++k) squares += std::pow(base[k] - bold[k] - mean, 2);
  const double error = std::sqrt(squares / std::max(n - 1, 1.0) / static_cast<double>(count));
  return mean == 0 ? 0 : mean / error;
}

bool is_better_in_the_worst(std::span<const double> bold, std::span<const double> base) {
  std::pair<double, double> mine, its;
  for (std::size_t part = 0; part < kParts; ++part) {
    const std::size_t begin = part * bold.size() / kParts, end = (part + 1) * bold.size() / kParts;
    const double worst = most(bold.subspan(begin, end - begin)), other = most(base.subspan(begin, end - begin));
    if (worst > other) return false;
    mine.first += worst;
    its.first += other;
  }
  mine.second = sum(bold);
  its.second = sum(base);
  return mine < its;
}

/// Real drives of all whole policies, in more and more worlds.
class Trials {
 public:
  Trials(LatticePlanner& planner, RolloutPolicy& policy)
      : planner_(planner), policy_(policy), is_sure_(has_sure_way(planner)) {}

  /// Worlds in which any does not reach the goal count for none.
  void drive_until(std::size_t draws) {
    for (const RoadblockSet open : policy_.worlds(drawn_, draws)) {
      const double hoped = steps_of(*make_driver(DriverKind::optimist, planner_), open);
      const std::array<double, 3> steps{hoped, is_sure_ ? by(&RolloutPolicy::fear, open) : hoped,
                                        by(&RolloutPolicy::choose, open)};
      if (std::ranges::find(steps, 0.0) != steps.end()) continue;
      for (std::size_t k = 0; k < steps.size(); ++k) steps_[k].push_back(steps[k]);
    }
    drawn_ = draws;
  }

  const Steps& operator[](Whole whole) const { return steps_[static_cast<std::size_t>(whole)]; }

 private:
  /// The pessimist is an optimist who knows a sure way.
  static bool has_sure_way(LatticePlanner& planner) {
    const Course& course = planner.course();
    return planner.estimate({course.start.x, course.start.y, 0}, ObservedMap(course).all()).has_value();
  }

  double by(Choice (RolloutPolicy::*decide)(const Pose&, RoadblockSet, RoadblockSet), RoadblockSet open) {
    const Choose choose = [&](const Pose& from, RoadblockSet seen_open, RoadblockSet closed) {
      return (policy_.*decide)(from, seen_open, closed);
    };
    TrialDriver driver(choose);
    return steps_of(driver, open);
  }

  double steps_of(Driver& driver, RoadblockSet open) const {
    const Drive run = drive(planner_.course(), open, driver, planner_.reading());
    return run.outcome == Outcome::reached ? static_cast<double>(run.controls.size()) : 0;
  }

  LatticePlanner& planner_;
  RolloutPolicy& policy_;
  bool is_sure_;  ///< is there a way around all roadblocks?
  std::size_t drawn_ = 0;
  std::array<Steps, 3> steps_;
};

Whole base_of(const Trials& trials, Aim aim) {
  const auto key = [&](Whole whole) {
    const Steps& steps = trials[whole];
    return std::pair(aim == Aim::worst ? most(steps) : 0, sum(steps));
  };
  return key(Whole::fear) < key(Whole::hope) ? Whole::fear : Whole::hope;
}

}  // namespace

bool is_better(Aim aim, std::span<const double> bold, std::span<const double> base, std::size_t count) {
  if (bold.size() < kParts) return false;
  if (aim == Aim::worst) return is_better_in_the_worst(bold, base);
  return errors_less(bold, base, count) > kErrors;
}

Whole best_whole(LatticePlanner& planner, RolloutPolicy& policy, Aim aim) {
  Trials trials(planner, policy);
  trials.drive_until(kDraws);
  const std::size_t count = trials[Whole::hope].size();
  Whole base = base_of(trials, aim);
  if (count < kFew || std::abs(errors_less(trials[Whole::choose], trials[base], count) - kErrors) < 1) {
    trials.drive_until(kMore * kDraws);
    base = base_of(trials, aim);
  }
  return is_better(aim, trials[Whole::choose], trials[base], count) ? Whole::choose : base;
}

}  // namespace taut::roadblocks::detail
