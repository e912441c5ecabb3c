#include <taut/robots/roadblocks/rollout_policy.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/robots/roadblocks/detail/door_graph.h>

namespace taut::roadblocks {

namespace {

using detail::DoorGraph;
using detail::DoorSet;
using Choice = RoadblockPolicy::Choice;

/// Prices of unknown doors: from the optimist's to the pessimist's.
constexpr std::array<double, 5> kPrices{0, 50, 150, 500, std::numeric_limits<double>::infinity()};
constexpr double kLost = 5000;          // steps, where the places know no way out
constexpr double kDoubt = 0.97;         // of a value, which is an estimate
constexpr std::size_t kMostDraws = 20;  // a world that is asked for
constexpr std::uint64_t kSeed = 1;
constexpr std::size_t kPlannersMemory = 100'000'000;  // plans go around few sets of doors

struct Belief {
  DoorSet open = 0, closed = 0;
  bool is_known(DoorSet door) const { return ((open | closed) & door) != 0; }
  Belief after(DoorSet door, DoorSet world) const {
    return world & door ? Belief{open | door, closed} : Belief{open, closed | door};
  }
};

struct World {
  RoadblockSet blocks = 0;  ///< open
  DoorSet doors = 0;        ///< open
};

/// What to make for: the sight of an unknown door, or the goal.
struct Option {
  int node = 0;
  double value = std::numeric_limits<double>::infinity();
  double price = 0;  ///< by which the drive goes on if the door is open
  bool is_optimists = false;
};

}  // namespace

struct RolloutPolicy::Impl {
  Impl(LatticePlanner& p, Aim a, std::size_t w, std::vector<Door> all_doors)
      : planner(p), course(p.course()), aim(a), wanted(w), graph(course, p.reading(), std::move(all_doors)) {
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

  /// The next decision is due at the plan's first sight; from there the rest of it is known.
  void adopt(const DrivePlan& plan, RoadblockSet open, RoadblockSet closed) {
    const RoadblockSet unknown = ObservedMap(course).all() & ~(open | closed);
    for (std::size_t k = 0; k + 1 < plan.poses.size(); ++k)
      if (seen_from(plan.poses[k], course) & unknown) return planner.adopt(plan, k + 1, shut_by_choice);
  }

  Choice decided(const Pose& from, RoadblockSet open, RoadblockSet closed) {
    const Belief belief = belief_of(open, closed);
    const std::vector<double> legs = legs_at(from, open, closed, belief);
    const DrivePlan* hopeful = planned(from, closed);
    const DoorSet hoped = hopeful ? first_crossed(from, *hopeful, open) : 0;
    if (!hopeful || hoped == 0) return {hopeful, hopeful ? static_cast<double>(hopeful->controls.size()) : 0, false, 0};
    const Option option = best_option(legs, belief, hoped, worlds_for(legs, open, closed));
    const DrivePlan* plan = option.is_optimists ? hopeful : nullptr;
    if (!plan && option.value < DoorGraph::kFar) {
      const RoadblockSet passed = blocks_of(passed_by(legs, belief, option));
      for (const RoadblockSet shut : {closed | (at_doors & ~passed), closed | (at_doors & ~(passed | open))})
        if (!plan) plan = planned(from, shut);
    }
    if (!plan) plan = planned(from, closed);
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
    const DoorGraph::Ways hope = graph.ways(belief.open, belief.closed, 0);  // a copy: rollouts ask for many
    const std::vector<double> here = graph.from_here(legs, belief.open).first;
    Option best{graph.goal(), graph.first(legs, sure(belief), ~belief.open).second};
    Option optimist;
    for (int sight = 0; sight < graph.sides(); ++sight) {
      const double leg = here[static_cast<std::size_t>(sight)];
      if (belief.is_known(graph.door_of(sight)) || leg + hope.steps[static_cast<std::size_t>(sight)] >= best.value)
        continue;
      Option option = valued(sight, belief, worlds);
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

  const DoorGraph::Ways& sure(const Belief& belief) { return graph.ways(belief.open, belief.closed, kPrices.back()); }

  /// Of the drives on from a sight.
  Option valued(int sight, const Belief& belief, const std::vector<World>& worlds) {
    const DoorSet door = graph.door_of(sight);
    Option option{sight, 0, 0};
    for (const DoorSet state : {door, DoorSet{0}}) {
      const Belief then = belief.after(door, state);
      std::pair<double, double> best{std::numeric_limits<double>::infinity(), 0};
      for (const double price : kPrices)
        best = std::min(best, std::pair{together(sight, then, price, worlds, door, state), price});
      option.value = aim == Aim::expected ? option.value + best.first : std::max(option.value, best.first);
      if (state != 0) option.price = best.second;
    }
    if (aim == Aim::expected) option.value /= static_cast<double>(std::max<std::size_t>(worlds.size(), 1));
    return option;
  }

  /// The sum (maximum) of the drives in those worlds where the door's state is this.
  double together(int sight, const Belief& then, double price, const std::vector<World>& worlds, DoorSet door,
                  DoorSet state) {
    double all = 0;
    for (const World& world : worlds) {
      if ((world.doors & door) != state) continue;
      const double trap = state == 0 ? graph.trap(sight, world.blocks) : 0;
      const double steps = trap + rollout(sight, then, price, world);
      all = aim == Aim::expected ? all + steps : std::max(all, steps);
    }
    return all;
  }

  double rollout(int node, Belief belief, double price, const World& world) {
    double steps = 0;
    for (;;) {
      const auto at = static_cast<std::size_t>(node);
      const DoorGraph::Ways* ways = &graph.ways(belief.open, belief.closed, price);
      if (ways->steps[at] >= DoorGraph::kFar) ways = &graph.ways(belief.open, belief.closed, 0);
      if (ways->steps[at] >= DoorGraph::kFar) return steps + kLost;
      steps += ways->to_stop[at];
      node = ways->stop[at];
      if (node == graph.goal()) return steps;
      if (!(world.doors & graph.door_of(node))) steps += graph.trap(node, world.blocks);
      belief = belief.after(graph.door_of(node), world.doors);
    }
  }

  /// Random worlds that agree with what is known and have a way from here; the same draws for all decisions.
  std::vector<World> worlds_for(const std::vector<double>& legs, RoadblockSet open, RoadblockSet closed) {
    std::vector<World> worlds;
    for (std::size_t k = 0; k < kMostDraws * wanted && worlds.size() < wanted; ++k) {
      const RoadblockSet blocks = (drawn(k) | open) & ~closed;
      const DoorSet doors = belief_of(blocks, 0).open;
      if (graph.first(legs, graph.ways(doors, graph.all() & ~doors, 0), ~doors).second < DoorGraph::kFar)
        worlds.push_back({blocks, doors});
    }
    return worlds;
  }

  RoadblockSet drawn(std::size_t k) {
    while (draws.size() <= k) {
      RoadblockSet open = 0;
      for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
        if (random.unit() < course.roadblocks[b].open_probability) open |= RoadblockSet{1} << b;
      draws.push_back(open);
    }
    return draws[k];
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
  Aim aim;
  std::size_t wanted;
  DoorGraph graph;
  RoadblockSet at_doors = 0;
  RoadblockSet shut_by_choice = 0;  ///< of the last plan
  Draws random{kSeed};
  std::vector<RoadblockSet> draws;
  std::map<std::tuple<double, double, double, RoadblockSet, RoadblockSet>, Choice> kept;
};

RolloutPolicy::RolloutPolicy(LatticePlanner& planner, Aim aim, std::size_t worlds)
    : RolloutPolicy(std::make_unique<Impl>(planner, aim, worlds, doors(planner.course(), planner.reading()))) {}

RolloutPolicy::RolloutPolicy(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

RolloutPolicy::~RolloutPolicy() = default;

Choice RolloutPolicy::choose(const Pose& from, RoadblockSet open, RoadblockSet closed) {
  return impl_->choose(from, open, closed);
}

RoadblockSet RolloutPolicy::relevant() { return impl_->relevant(); }

std::unique_ptr<RolloutPolicy> RolloutPolicy::within(LatticePlanner& planner, Aim aim, std::size_t bytes) {
  std::vector<Door> all = doors(planner.course(), planner.reading());
  if (DoorGraph::bytes(planner.course(), all) > bytes) return nullptr;
  return std::unique_ptr<RolloutPolicy>(
      new RolloutPolicy(std::make_unique<Impl>(planner, aim, kWorlds, std::move(all))));
}

std::size_t RolloutPolicy::decisions() const { return impl_->kept.size(); }

}  // namespace taut::roadblocks
