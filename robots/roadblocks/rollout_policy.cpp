#include <taut/robots/roadblocks/rollout_policy.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/robots/roadblocks/detail/door_uct.h>
#include <taut/robots/roadblocks/detail/door_values.h>

namespace taut::roadblocks {

namespace {

using detail::Belief;
using detail::DoorGraph;
using detail::DoorSet;
using detail::Option;
using detail::World;
using Choice = RoadblockPolicy::Choice;

constexpr double kDoubt = 0.97;         // of a value, which is an estimate
constexpr std::size_t kMostDraws = 20;  // a world that is asked for
constexpr std::uint64_t kSeed = 1, kTrialSeed = 2;
constexpr std::size_t kPlannersMemory = 60'000'000;  // plans go around few sets of doors

/// Open roadblocks, drawn one after the other.
class DrawnWorlds {
 public:
  explicit DrawnWorlds(std::uint64_t seed) : random_(seed) {}

  RoadblockSet number(std::size_t k, const Course& course) {
    while (drawn_.size() <= k) {
      RoadblockSet open = 0;
      for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
        if (random_.unit() < course.roadblocks[b].open_probability) open |= RoadblockSet{1} << b;
      drawn_.push_back(open);
    }
    return drawn_[k];
  }

 private:
  Draws random_;
  std::vector<RoadblockSet> drawn_;
};

}  // namespace

struct RolloutPolicy::Impl {
  Impl(LatticePlanner& p, Aim aim, Look l, DoorGraph g)
      : planner(p), course(p.course()), look(l), graph(std::move(g)), values(graph, aim) {
    for (const Door& door : graph.doors()) at_doors |= door.blocks;
    planner.keep_at_most(kPlannersMemory);
  }

  Choice choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    const std::tuple key{from.x, from.y, from.heading, open, closed};
    const auto at = kept.find(key);
    if (at != kept.end()) return at->second;
    Choice choice = decided(from, open, closed);
    choice.relevant = ObservedMap(course).all();
    if (choice.plan) adopt(*choice.plan, open, closed);
    return kept.emplace(key, choice).first->second;
  }

  Choice hope(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    return kept_whole(hopeful(from, closed), open, closed);
  }

  Choice fear(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    const RoadblockSet shut = ObservedMap(course).all() & ~open;
    const DrivePlan* plan = planner.estimate(from, shut) ? planned(from, shut) : nullptr;
    return plan ? kept_whole(plan, open, closed) : hope(from, open, closed);
  }

  Choice kept_whole(const DrivePlan* plan, RoadblockSet open, RoadblockSet closed) {
    if (plan) adopt(*plan, open, closed);
    return {plan, plan ? static_cast<double>(plan->controls.size()) : 0, false, ObservedMap(course).all()};
  }

  /// The next decision is due at the plan's first sight; from there the rest of it is known.
  void adopt(const DrivePlan& plan, RoadblockSet open, RoadblockSet closed) {
    const RoadblockSet unknown = ObservedMap(course).all() & ~(open | closed);
    for (std::size_t k = 0; k + 1 < plan.poses.size(); ++k)
      if (seen_from(plan.poses[k], course) & unknown) return planner.adopt(plan, k + 1, shut_by_choice);
  }

  Choice decided(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    const Belief belief = belief_of(open, closed);
    const std::vector<double> legs = legs_at(from, open, closed, belief);
    const DrivePlan* hope = hopeful(from, closed);
    const DoorSet hoped = hope ? first_crossed(from, *hope, open) : 0;
    if (!hope || hoped == 0) return {hope, hope ? static_cast<double>(hope->controls.size()) : 0, false, 0};
    const Option option = best_option(legs, belief, hoped, worlds_for(legs, open, closed));
    const DrivePlan* plan = option.is_optimists ? hope : nullptr;
    if (!plan && option.value < DoorGraph::kFar) {
      const RoadblockSet passed = blocks_of(passed_by(legs, belief, option));
      for (const RoadblockSet shut : {closed | (at_doors & ~passed), closed | (at_doors & ~(passed | open))})
        if (!plan) plan = planned(from, shut);
    }
    if (!plan) plan = hopeful(from, closed);
    return {plan, plan ? option.value : 0, false, 0};
  }

  /// The door that the plan crosses first of those not known to be open.
  DoorSet first_crossed(const Pose& from, const DrivePlan& plan, RoadblockSet open) const {
    RoadblockSet crossed = 0;
    for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
      if (!((open >> b) & 1) && crosses(from, plan, course.roadblocks[b], planner.reading()))
        crossed |= RoadblockSet{1} << b;
    for (const Pose& pose : plan.poses)
      if (const RoadblockSet seen = seen_from(pose, course) & crossed)
        for (std::size_t d = 0; d < graph.doors().size(); ++d)
          if (graph.doors()[d].blocks & seen) return DoorSet{1} << d;
    return 0;
  }

  std::vector<double> legs_at(const Pose& from, RoadblockSet open, RoadblockSet closed, const Belief& belief) const {
    std::vector<double> legs = graph.legs_from(from, belief.open);
    const RoadblockSet seen = seen_from(from, course);
    for (std::size_t d = 0; d < graph.doors().size(); ++d) {
      const RoadblockSet blocks = graph.doors()[d].blocks;
      if ((blocks & closed) == 0 && (blocks & ~open) != 0 && (blocks & open & seen) != 0)
        graph.stand_at(static_cast<int>(d), from, legs);
    }
    return legs;
  }

  const DrivePlan* planned(const Pose& from, RoadblockSet shut) {
    shut_by_choice = shut;
    return planner.plan(from, shut);
  }

  /// Around whole doors where one of their roadblocks is closed, so that it is the same plan whichever is; but not from
  /// between them.
  const DrivePlan* hopeful(const Pose& from, RoadblockSet closed) {
    const RoadblockSet shut = closed | blocks_of(belief_of(0, closed).closed);
    if (shut != closed && planner.estimate(from, shut))
      if (const DrivePlan* plan = planned(from, shut)) return plan;
    return planned(from, closed);
  }

  Belief belief_of(RoadblockSet open, RoadblockSet closed) const {
    Belief belief;
    for (std::size_t d = 0; d < graph.doors().size(); ++d) {
      const RoadblockSet blocks = graph.doors()[d].blocks;
      if (blocks & closed) belief.closed |= DoorSet{1} << d;
      if ((blocks & ~open) == 0) belief.open |= DoorSet{1} << d;
    }
    return belief;
  }

  RoadblockSet blocks_of(DoorSet doors) const {
    RoadblockSet blocks = 0;
    for (; doors != 0; doors &= doors - 1)
      blocks |= graph.doors()[static_cast<std::size_t>(std::countr_zero(doors))].blocks;
    return blocks;
  }

  /// The optimist's, unless another is better by more than what the estimates may be wrong.
  Option best_option(const std::vector<double>& legs, const Belief& belief, DoorSet hoped,
                     const std::vector<World>& worlds) {
    if (look == Look::uct) return detail::uct_option(graph, legs, belief, hoped, worlds);
    const DoorGraph::Ways hope = graph.ways(belief.open, belief.closed, 0);  // a copy: rollouts ask for many
    const std::vector<double> here = graph.from_here(legs, belief.open).first;
    Option best{graph.goal(), graph.first(legs, sure(belief), ~belief.open).second};
    Option optimist;
    for (int sight = 0; sight < graph.sides(); ++sight) {
      const double leg = here[static_cast<std::size_t>(sight)];
      if (belief.is_known(graph.door_of(sight)) || leg + hope.steps[static_cast<std::size_t>(sight)] >= best.value)
        continue;
      Option option = values.of(sight, belief, worlds);
      option.value += leg;
      option.is_optimists = graph.door_of(sight) == hoped;
      if (option.is_optimists && option.value < optimist.value) optimist = option;
      if (option.value < best.value) best = option;
    }
    return optimist.value * kDoubt < best.value ? optimist : best;
  }

  RoadblockSet relevant() {
    const std::vector<double> legs = graph.legs_from({course.start.x, course.start.y, 0}, 0);
    const double least = graph.first(legs, sure({}), graph.all()).second;
    const std::vector<double> here = graph.from_here(legs, graph.all()).first;
    const DoorGraph::Ways& hope = graph.ways(graph.all(), 0, 0);
    DoorSet found = 0;
    for (int sight = 0; sight < graph.sides(); ++sight)
      if (const auto at = static_cast<std::size_t>(sight); here[at] + hope.steps[at] < least)
        found |= graph.door_of(sight);
    return blocks_of(found);
  }

  const DoorGraph::Ways& sure(const Belief& belief) {
    return graph.ways(belief.open, belief.closed, std::numeric_limits<double>::infinity());
  }

  /// Random worlds that agree with what is known and have a way from here; the same draws for all decisions.
  std::vector<World> worlds_for(const std::vector<double>& legs, RoadblockSet open, RoadblockSet closed) {
    std::vector<World> worlds;
    for (std::size_t k = 0; k < kMostDraws * kWorlds && worlds.size() < kWorlds; ++k) {
      const RoadblockSet blocks = (draws.number(k, course) | open) & ~closed;
      if (has_way(legs, blocks)) worlds.push_back({blocks, belief_of(blocks, 0).open});
    }
    return worlds;
  }

  bool has_way(const std::vector<double>& legs, RoadblockSet blocks) {
    const DoorSet doors = belief_of(blocks, 0).open;
    return graph.first(legs, graph.ways(doors, graph.all() & ~doors, 0), ~doors).second < DoorGraph::kFar;
  }

  std::vector<RoadblockSet> worlds(std::size_t begin, std::size_t end) {
    const std::vector<double> legs = graph.legs_from({course.start.x, course.start.y, 0}, 0);
    std::vector<RoadblockSet> open;
    for (std::size_t k = begin; k < end; ++k)
      if (const RoadblockSet blocks = trials.number(k, course); has_way(legs, blocks)) open.push_back(blocks);
    return open;
  }

  /// The doors of the way that an option hopes for.
  DoorSet passed_by(const std::vector<double>& legs, const Belief& belief, const Option& option) {
    DoorSet passed = 0;
    const auto& before = graph.from_here(legs, belief.open).second;
    for (int v = option.node; v >= 0; v = before[static_cast<std::size_t>(v)]) passed |= passed_at(v);
    if (option.node == graph.goal()) return passed;
    const DoorSet door = graph.door_of(option.node);
    const DoorGraph::Ways* ways = &graph.ways(belief.open | door, belief.closed, option.price);
    if (ways->steps[static_cast<std::size_t>(option.node)] >= DoorGraph::kFar)
      ways = &graph.ways(belief.open | door, belief.closed, 0);
    for (int v = option.node; v >= 0; v = ways->next[static_cast<std::size_t>(v)]) passed |= passed_at(v);
    return passed;
  }

  DoorSet passed_at(int node) const { return graph.is_beyond(node) ? graph.door_of(graph.side_of(node)) : 0; }

  LatticePlanner& planner;
  const Course& course;
  Look look;
  DoorGraph graph;
  detail::DoorValues values;
  RoadblockSet at_doors = 0;
  RoadblockSet shut_by_choice = 0;  ///< of the last plan
  DrawnWorlds draws{kSeed}, trials{kTrialSeed};
  std::map<std::tuple<double, double, double, RoadblockSet, RoadblockSet>, Choice> kept;
};

namespace {

std::optional<DoorGraph> graph_within(std::size_t bytes, const LatticePlanner& planner) {
  return DoorGraph::within(bytes, planner.course(), planner.reading(), doors(planner.course(), planner.reading()));
}

}  // namespace

RolloutPolicy::RolloutPolicy(LatticePlanner& planner, Aim aim, Look look)
    : RolloutPolicy(std::make_unique<Impl>(planner, aim, look,
                                           *graph_within(std::numeric_limits<std::size_t>::max(), planner))) {}

RolloutPolicy::RolloutPolicy(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

RolloutPolicy::~RolloutPolicy() = default;

Choice RolloutPolicy::choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
  return impl_->choose(from, open, closed);
}

Choice RolloutPolicy::hope(const Pose& from, RoadblockSet open, RoadblockSet closed) {
  return impl_->hope(from, open, closed);
}

Choice RolloutPolicy::fear(const Pose& from, RoadblockSet open, RoadblockSet closed) {
  return impl_->fear(from, open, closed);
}

std::vector<RoadblockSet> RolloutPolicy::worlds(std::size_t begin, std::size_t end) {
  return impl_->worlds(begin, end);
}

RoadblockSet RolloutPolicy::relevant() { return impl_->relevant(); }

std::unique_ptr<RolloutPolicy> RolloutPolicy::within(LatticePlanner& planner, Aim aim, std::size_t bytes) {
  std::optional<DoorGraph> graph = graph_within(bytes, planner);
  if (!graph) return nullptr;
  return std::unique_ptr<RolloutPolicy>(
      new RolloutPolicy(std::make_unique<Impl>(planner, aim, Look::rollouts, *std::move(graph))));
}

std::size_t RolloutPolicy::decisions() const { return impl_->kept.size(); }

}  // namespace taut::roadblocks
