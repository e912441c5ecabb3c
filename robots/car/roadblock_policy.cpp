#include <taut/robots/car/roadblock_policy.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace taut::car {

namespace {

constexpr std::size_t kMostWays = 64;  // to choose from in one place

constexpr int kMostTold = 4;     // unknown roadblocks for whose outcomes bounds are made
constexpr double kTrust = 0.98;  // in estimates, as bounds

/// A way to choose: followed for `steps`, where `seen` comes into sight. Without a sight it leads to the goal.
struct Way {
  const Plan* plan = nullptr;
  RoadblockSet shut = 0;  ///< what it was planned around
  std::size_t steps = 0;
  RoadblockSet seen = 0;
  double bound = 0;  ///< its value is no less
};

}  // namespace

struct RoadblockPolicy::Impl {
  Impl(LatticePlanner& p, Aim a, std::size_t s) : planner(p), course(p.course()), aim(a), searches(s) {}

  /// The first guess that only what the shortest way crosses matters is corrected until nothing else is crossed by any way.
  Choice choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    for (;;) {
      const RoadblockSet before = relevant;
      guessed.clear();
      Choice choice = value(from, open & relevant, closed & relevant);
      choice.relevant = relevant;
      if (relevant == before) return choice;
      known.clear();
    }
  }

  /// Relevant ones.
  RoadblockSet unknown(RoadblockSet open, RoadblockSet closed) const { return relevant & ~(open | closed); }

  /// Not known to be open, and met; all of them are relevant from now on.
  RoadblockSet crossed(const Pose& from, const Plan& plan, RoadblockSet open) {
    RoadblockSet all = 0;
    for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
      if (const RoadblockSet block = RoadblockSet{1} << b;
          !(open & block) && crosses(from, plan, course.roadblocks[b], planner.reading()))
        all |= block;
    relevant |= all;
    return all;
  }

  const Plan* from_start(RoadblockSet closed) { return planner.plan({course.start.x, course.start.y, 0}, closed); }
  bool is_spent() const { return planner.plans() > most_plans; }

  Choice value(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    const std::tuple key{from.x, from.y, from.heading, open, closed};
    if (const auto at = known.find(key); at != known.end()) return at->second;
    if (const auto at = guessed.find(key); at != guessed.end()) return at->second;
    const Choice choice = decided(from, open, closed);
    (choice.exact ? known : guessed).emplace(key, choice);
    return choice;
  }

  Choice decided(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    const Plan* direct = planner.plan(from, closed);
    if (!direct) return {nullptr, from_start(closed) ? kStranded : 0, true};
    Choice best{direct, static_cast<double>(direct->controls.size()), true};
    if (crossed(from, *direct, open) == 0) return best;
    best.exact = false;
    if (is_spent()) return best;
    best = {direct, std::numeric_limits<double>::infinity(), true};
    bool exact = true;
    for (const Way& way : ways(from, open, closed)) {
      if (way.bound >= best.value) continue;
      const Choice tried = along(way, open, closed);
      exact = exact && tried.exact;
      if (tried.value < best.value) best = tried;
    }
    best.exact = exact;
    return best;
  }

  /// Those without a sight first, then by their bounds.
  std::vector<Way> ways(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    std::vector<Way> found;
    std::set<RoadblockSet> asked{0};
    std::vector<RoadblockSet> avoid{0};
    std::set<std::pair<std::size_t, std::tuple<double, double, double>>> places;
    for (std::size_t i = 0; i < avoid.size() && i < kMostWays; ++i) {
      const RoadblockSet avoided = avoid[i];
      if (i > 0 && is_spent()) break;
      const Plan* plan = planner.plan(from, closed | avoided);
      if (!plan) continue;
      for (RoadblockSet met = crossed(from, *plan, open); met != 0; met &= met - 1)
        if (const RoadblockSet block = met & (~met + 1); asked.insert(avoided | block).second)
          avoid.push_back(avoided | block);
      Way way = way_along(*plan, closed | avoided, unknown(open, closed));
      const Pose& end = plan->poses.empty() ? from : plan->poses[way.steps - 1];
      if (!places.insert({way.steps, {end.x, end.y, end.heading}}).second) continue;
      way.bound = static_cast<double>(way.steps) + (way.seen == 0 ? 0 : least_from(end, open, closed));
      found.push_back(way);
    }
    std::ranges::stable_sort(found, {}, [](const Way& w) { return std::pair(w.seen != 0, w.bound); });
    return found;
  }

  Way way_along(const Plan& plan, RoadblockSet shut, RoadblockSet unknown) const {
    for (std::size_t k = 0; k + 1 < plan.poses.size(); ++k)
      if (const RoadblockSet seen = seen_from(plan.poses[k], course) & unknown) return {&plan, shut, k + 1, seen, 0};
    return {&plan, shut, plan.poses.size(), 0, 0};
  }

  /// What even somebody needs from there who is told everything: the mean, or the maximum, of estimates over all outcomes. Where there is no way, nothing.
  double least_from(const Pose& there, RoadblockSet open, RoadblockSet closed) {
    RoadblockSet rest = unknown(open, closed);
    while (std::popcount(rest) > kMostTold) rest &= rest - 1;  // the others open
    double least = 0;
    for (RoadblockSet now_open = rest;; now_open = (now_open - 1) & rest) {
      if (const double p = probability(now_open, rest); p > 0)
        if (const auto steps = planner.estimate(there, closed | (rest & ~now_open)))
          least = aim == Aim::expected ? least + p * kTrust * *steps : std::max(least, kTrust * *steps);
      if (now_open == 0) break;
    }
    return least;
  }

  Choice along(const Way& way, RoadblockSet open, RoadblockSet closed) {
    if (way.seen == 0) return {way.plan, static_cast<double>(way.steps), true};
    planner.adopt(*way.plan, way.steps, way.shut);
    const Pose& there = way.plan->poses[way.steps - 1];
    double rest = 0;
    bool exact = true;
    for (RoadblockSet now_open = way.seen;; now_open = (now_open - 1) & way.seen) {
      if (const double p = probability(now_open, way.seen); p > 0) {
        const Choice then = value(there, open | now_open, closed | (way.seen & ~now_open));
        exact = exact && then.exact;
        rest = aim == Aim::expected ? rest + p * then.value : std::max(rest, then.value);
      }
      if (now_open == 0) break;
    }
    return {way.plan, static_cast<double>(way.steps) + rest, exact};
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
  std::size_t most_plans = 0;
  RoadblockSet relevant = 0;
  std::map<std::tuple<double, double, double, RoadblockSet, RoadblockSet>, Choice> known,
      guessed;  ///< the latter for one choice
};

RoadblockPolicy::RoadblockPolicy(LatticePlanner& planner, Aim aim, std::size_t searches)
    : impl_(std::make_unique<Impl>(planner, aim, searches)) {}

RoadblockPolicy::~RoadblockPolicy() = default;

RoadblockPolicy::Choice RoadblockPolicy::choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
  impl_->most_plans = impl_->planner.plans() + impl_->searches;
  return impl_->choose(from, open, closed);
}

}  // namespace taut::car
