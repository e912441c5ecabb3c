#include <taut/robots/roadblocks/roadblock_policy.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace taut::roadblocks {

namespace {

constexpr std::size_t kManyPlans = 400;       // of the planner, after which a choice gets a fifth of its searches
constexpr std::size_t kStatesASearch = 1000;  // on the average, and more than most need
constexpr std::size_t kMostWays = 64;         // to choose from in one place

constexpr double kTrust = 0.98;  // in estimates, as bounds

/// A way to choose: followed for `steps`, where `seen` comes into sight. Without a sight it leads to the goal.
struct Way {
  const DrivePlan* plan = nullptr;
  RoadblockSet shut = 0;  ///< what it was planned around
  std::size_t steps = 0;
  RoadblockSet seen = 0;
  const Pose& end() const { return plan->poses[steps - 1]; }  ///< precondition: seen
};

}  // namespace

struct RoadblockPolicy::Impl {
  Impl(LatticePlanner& p, Aim a, std::size_t s) : planner(p), course(p.course()), aim(a), searches(s) {}

  /// The first guess that only what the shortest way crosses matters is corrected until nothing else is crossed by any
  /// way.
  Choice choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    for (;;) {
      const RoadblockSet before = relevant;
      guessed.clear();
      Choice choice = *value(from, open & relevant, closed & relevant, std::numeric_limits<double>::infinity());
      choice.relevant = relevant;
      if (relevant == before) return choice;
      known.clear();
      no_less.clear();
    }
  }

  /// Relevant ones.
  RoadblockSet unknown(RoadblockSet open, RoadblockSet closed) const { return relevant & ~(open | closed); }

  /// Not known to be open, and met; all of them are relevant from now on.
  RoadblockSet crossed(const Pose& from, const DrivePlan& plan, RoadblockSet open) {
    RoadblockSet all = 0;
    for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
      if (const RoadblockSet block = RoadblockSet{1} << b;
          !(open & block) && crosses(from, plan, course.roadblocks[b], planner.reading()))
        all |= block;
    relevant |= all;
    return all;
  }

  const DrivePlan* from_start(RoadblockSet closed) { return planner.plan({course.start.x, course.start.y, 0}, closed); }
  bool is_spent() const { return planner.plans() > most_plans || planner.expanded() > most_expanded; }

  /// Nothing when the value is no less than `limit`.
  std::optional<Choice> value(const Pose& from, RoadblockSet open, RoadblockSet closed, double limit) {
    const std::tuple key{from.x, from.y, from.heading, open, closed};
    if (const auto at = known.find(key); at != known.end()) return at->second;
    if (const auto at = guessed.find(key); at != guessed.end()) return at->second;
    if (const auto at = no_less.find(key); at != no_less.end() && at->second >= limit) return std::nullopt;
    const std::optional<Choice> choice = decided(from, open, closed, limit);
    if (!choice)
      no_less[key] = limit;
    else
      (choice->exact ? known : guessed).emplace(key, *choice);
    return choice;
  }

  std::optional<Choice> decided(const Pose& from, RoadblockSet open, RoadblockSet closed, double limit) {
    const DrivePlan* direct = planner.plan(from, closed);
    if (!direct) return Choice{nullptr, from_start(closed) ? kStranded : 0, true};
    const Choice optimist{direct, static_cast<double>(direct->controls.size()), false};
    if (crossed(from, *direct, open) == 0) return Choice{direct, optimist.value, true};
    if (is_spent()) return optimist;
    const double floor = least_from(from, closed);
    if (floor >= limit) return std::nullopt;
    Choice best{nullptr, limit, true};
    bool exact = true;
    each_way(from, open, closed, [&](const Way& way) {
      if (const auto tried = along(way, open, closed, best.value)) {
        exact = exact && tried->exact;
        best = *tried;
      }
      return floor < best.value;
    });
    if (!best.plan) return std::nullopt;
    best.exact = exact;
    return best;
  }

  /// While visit says so, the shortest first, then around one roadblock that it or one of those after it crosses, then
  /// around two.
  template <typename Visit>
  void each_way(const Pose& from, RoadblockSet open, RoadblockSet closed, Visit visit) {
    std::set<RoadblockSet> asked{0};
    std::vector<RoadblockSet> avoid{0};
    std::set<std::pair<std::size_t, std::tuple<double, double, double>>> places;
    for (std::size_t i = 0; i < avoid.size() && i < kMostWays; ++i) {
      const RoadblockSet avoided = avoid[i];
      if (i > 0 && is_spent()) return;
      const DrivePlan* plan = planner.plan(from, closed | avoided);
      if (!plan) continue;
      for (RoadblockSet met = crossed(from, *plan, open); met != 0; met &= met - 1)
        if (const RoadblockSet block = met & (~met + 1); asked.insert(avoided | block).second)
          avoid.push_back(avoided | block);
      const Way way = way_along(*plan, closed | avoided, unknown(open, closed));
      const Pose& end = way.end();
      if (places.insert({way.steps, {end.x, end.y, end.heading}}).second && !visit(way)) return;
    }
  }

  Way way_along(const DrivePlan& plan, RoadblockSet shut, RoadblockSet unknown) const {
    for (std::size_t k = 0; k + 1 < plan.poses.size(); ++k)
      if (const RoadblockSet seen = seen_from(plan.poses[k], course) & unknown) return {&plan, shut, k + 1, seen};
    return {&plan, shut, plan.poses.size(), 0};
  }

  /// What even somebody needs from there who finds all unknown ones open. Where there is no way, nothing.
  double least_from(const Pose& there, RoadblockSet closed) {
    return kTrust * planner.estimate(there, closed).value_or(0);
  }

  struct Outcome {
    double p = 0;
    RoadblockSet open = 0, closed = 0;
    double least = 0;  ///< steps from there
  };

  /// Of what is seen on the way, the likeliest first.
  std::vector<Outcome> outcomes(const Way& way, RoadblockSet open, RoadblockSet closed) {
    std::vector<Outcome> all;
    for (RoadblockSet now_open = way.seen;; now_open = (now_open - 1) & way.seen) {
      if (const double p = probability(now_open, way.seen); p > 0) {
        const RoadblockSet now_closed = closed | (way.seen & ~now_open);
        all.push_back({p, open | now_open, now_closed, least_from(way.end(), now_closed)});
      }
      if (now_open == 0) break;
    }
    std::ranges::stable_sort(all, std::greater<>(), &Outcome::p);
    return all;
  }

  /// Nothing when it is no less than `limit`.
  std::optional<Choice> along(const Way& way, RoadblockSet open, RoadblockSet closed, double limit) {
    const double steps = static_cast<double>(way.steps);
    if (way.seen == 0) return steps < limit ? std::optional(Choice{way.plan, steps, true}) : std::nullopt;
    if (steps + least_from(way.end(), closed) >= limit) return std::nullopt;
    planner.adopt(*way.plan, way.steps, way.shut);
    const std::vector<Outcome> all = outcomes(way, open, closed);
    double least = 0;  // of those not yet valued
    for (const Outcome& o : all) least += o.p * o.least;
    Choice choice{way.plan, 0, true};
    for (const Outcome& o : all) {
      least -= o.p * o.least;
      const double rest = limit - steps;
      const auto then =
          value(way.end(), o.open, o.closed, aim == Aim::expected ? (rest - choice.value - least) / o.p : rest);
      if (!then) return std::nullopt;
      choice.exact = choice.exact && then->exact;
      choice.value = aim == Aim::expected ? choice.value + o.p * then->value : std::max(choice.value, then->value);
    }
    choice.value += steps;
    return choice.value < limit ? std::optional(choice) : std::nullopt;
  }

  /// That of `seen` exactly `now_open` are open.
  double probability(RoadblockSet now_open, RoadblockSet seen) const {
    double p = 1;
    for (; seen != 0; seen &= seen - 1) {
      const double open = course.roadblocks[static_cast<std::size_t>(std::countr_zero(seen))].open_probability;
      p *= (now_open & seen & (~seen + 1)) ? open : 1 - open;
    }
    return p;
  }

  LatticePlanner& planner;
  const Course& course;
  Aim aim;
  std::size_t searches;
  std::size_t most_plans = 0, most_expanded = 0;
  RoadblockSet relevant = 0;
  using State = std::tuple<double, double, double, RoadblockSet, RoadblockSet>;
  std::map<State, Choice> known, guessed;  ///< the latter for one choice
  std::map<State, double> no_less;
};

RoadblockPolicy::RoadblockPolicy(LatticePlanner& planner, Aim aim, std::size_t searches)
    : impl_(std::make_unique<Impl>(planner, aim, searches)) {}

RoadblockPolicy::~RoadblockPolicy() = default;

RoadblockPolicy::Choice RoadblockPolicy::choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
  const std::size_t so_far = impl_->planner.plans();
  const std::size_t searches = so_far < kManyPlans ? impl_->searches : impl_->searches / 5;
  impl_->most_plans = so_far + searches;
  impl_->most_expanded = impl_->planner.expanded() + kStatesASearch * searches;
  return impl_->choose(from, open, closed);
}

}  // namespace taut::roadblocks
