#include <taut/robots/roadblocks/detail/door_values.h>

#include <algorithm>
#include <array>

namespace taut::roadblocks::detail {

namespace {

/// Prices of unknown doors: from the optimist's to the pessimist's.
constexpr std::array<double, 5> kPrices{0, 50, 150, 500, std::numeric_limits<double>::infinity()};
constexpr double kLost = 5000;  // steps, where the places know no way out

}  // namespace

double rollout(DoorGraph& graph, int node, Belief belief, double price, const World& world) {
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

/// Of the drives on from a sight.
Option DoorValues::of(int sight, const Belief& belief, const std::vector<World>& worlds) {
  const DoorSet door = graph_.door_of(sight);
  Option option{sight, 0, 0};
  for (const DoorSet state : {door, DoorSet{0}}) {
    const Belief then = belief.after(door, state);
    std::pair<double, double> best{std::numeric_limits<double>::infinity(), 0};
    for (const double price : kPrices)
      best = std::min(best, std::pair{together(sight, then, price, worlds, door, state), price});
    option.value = aim_ == Aim::expected ? option.value + best.first : std::max(option.value, best.first);
    if (state != 0) option.price = best.second;
  }
  if (aim_ == Aim::expected) option.value /= static_cast<double>(std::max<std::size_t>(worlds.size(), 1));
  return option;
}

/// The sum (maximum) of the drives in those worlds where the door's state is this.
double DoorValues::together(int sight, const Belief& then, double price, const std::vector<World>& worlds, DoorSet door,
                            DoorSet state) {
  double all = 0;
  for (const World& world : worlds) {
    if ((world.doors & door) != state) continue;
    const double trap = state == 0 ? graph_.trap(sight, world.blocks) : 0;
    const double steps = trap + rollout(graph_, sight, then, price, world);
    all = aim_ == Aim::expected ? all + steps : std::max(all, steps);
  }
  return all;
}

}  // namespace taut::roadblocks::detail
