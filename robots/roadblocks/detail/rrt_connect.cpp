// RRT-Connect: a tree from the car, and one of poses from which known controls lead to the goal.
#include <cmath>
#include <numbers>
#include <utility>

#include <taut/robots/roadblocks/detail/growth.h>
#include <taut/robots/roadblocks/detail/pose_index.h>
#include <taut/robots/roadblocks/detail/steering.h>
#include <taut/robots/roadblocks/detail/tree_search.h>

namespace taut::roadblocks::detail {

namespace {

constexpr int kGoalHeadings = 16;

using Controls = std::vector<double>;

/// Poses, each with controls that are driven from its parent to it (the car's tree) or from it to its parent (the
/// goal's).
class Tree {
 public:
  std::uint32_t add(const Pose& pose, std::uint32_t parent, std::span<const double> controls) {
    const auto which = static_cast<std::uint32_t>(nodes_.size());
    index_.insert(pose, which);
    nodes_.push_back({pose, parent, controls, {}});
    return which;
  }
  std::optional<std::uint32_t> grow(const Pose& towards, const Growth& growth) {
    const std::uint32_t from = index_.nearest(towards);
    const auto branch = growth.towards(towards, nodes_[from].pose, nodes_[from].reach);
    return branch ? std::optional(add(branch->end, from, branch->controls)) : std::nullopt;
  }
  bool is_empty() const { return nodes_.empty(); }
  std::uint32_t nearest(const Pose& pose) const { return index_.nearest(pose); }
  const Pose& pose(std::uint32_t which) const { return nodes_[which].pose; }

  /// All legs as they are driven.
  void keep(std::vector<TreeBranch>* tree, bool from_goal) const {
    for (const Node& node : nodes_)
      if (tree && node.parent != kRoot)
        tree->push_back(branch_of(from_goal ? node.pose : nodes_[node.parent].pose, node.controls, from_goal));
  }

  /// The controls of each leg from a node up to its root.
  std::vector<std::span<const double>> to_root(std::uint32_t which) const {
    std::vector<std::span<const double>> legs;
    for (; which != kRoot; which = nodes_[which].parent) legs.push_back(nodes_[which].controls);
    return legs;
  }

 private:
  struct Node {
    Pose pose;
    std::uint32_t parent;
    std::span<const double> controls;
    Reach reach;
  };
  std::vector<Node> nodes_;
  PoseIndex index_;
};

class RrtConnect {
 public:
  RrtConnect(const TreeRoom& room, const Pose& from, Samples samples)
      : room_(room), samples_(samples), ahead_(room, Growth::Time::forwards), behind_(room, Growth::Time::backwards) {
    cars_.add(from, kRoot, {});
    plant_goals();
  }

  std::optional<Controls> run() {
    if (goals_.is_empty()) return std::nullopt;
    if (auto all = joined(0, goals_.nearest(cars_.pose(0)))) return all;
    for (std::size_t i = 0; i < samples_.most; ++i) {
      ++samples_.drawn;
      const Pose sample = room_.sample(samples_.draws);
      if (auto all = i % 2 == 0 ? from_car(sample) : from_goal(sample)) return all;
    }
    return std::nullopt;
  }

  void keep(std::vector<TreeBranch>* tree) const {
    cars_.keep(tree, false);
    goals_.keep(tree, true);
  }

 private:
  /// Poses well over the goal: it may be near the car's nose, middle or tail, and aside.
  void plant_goals() {
    const Point goal = room_.course().goal;
    for (int h = 0; h < kGoalHeadings; ++h)
      for (const double along : {0.0, 1.1, -1.1})
        for (const double across : {0.0, 0.6, -0.6}) {
          const double heading = h * 2 * std::numbers::pi / kGoalHeadings, c = std::cos(heading), s = std::sin(heading);
          const Pose pose{goal.x + along * c - across * s, goal.y + along * s + across * c, heading};
          if (room_.stands_clear(pose)) goals_.add(pose, kRoot, {});
        }
  }

  std::optional<Controls> from_car(const Pose& sample) {
    const auto added = grow_car(sample);
    if (!added) return std::nullopt;
    const Pose aim = cars_.pose(*added);
    while (true) {
      const std::uint32_t near = goals_.nearest(aim);
      if (auto all = joined(*added, near)) return all;
      const auto next = grow_goal(aim);
      if (!next || distance(goals_.pose(*next), aim) >= distance(goals_.pose(near), aim)) return std::nullopt;
    }
  }

  std::optional<Controls> from_goal(const Pose& sample) {
    const auto added = grow_goal(sample);
    if (!added) return std::nullopt;
    const Pose aim = goals_.pose(*added);
    while (true) {
      const std::uint32_t near = cars_.nearest(aim);
      if (auto all = joined(near, *added)) return all;
      const auto next = grow_car(aim);
      if (!next || distance(cars_.pose(*next), aim) >= distance(cars_.pose(near), aim)) return std::nullopt;
    }
  }

  std::optional<std::uint32_t> grow_car(const Pose& towards) { return cars_.grow(towards, ahead_); }
  std::optional<std::uint32_t> grow_goal(const Pose& towards) { return goals_.grow(towards, behind_); }

  /// All controls from the car to the goal over a joint of two nodes, if a joint lands near enough for the rest to be
  /// clear from there.
  std::optional<Controls> joined(std::uint32_t from, std::uint32_t to) const {
    for (const Steering& way : steerings(cars_.pose(from), goals_.pose(to))) {
      Controls all = way.controls();
      Pose end;
      if (!room_.drives(cars_.pose(from), all, end)) continue;
      for (const std::span<const double> leg : goals_.to_root(to)) all.insert(all.end(), leg.begin(), leg.end());
      if (room_.driven(cars_.pose(from), all).arrived) return after(from, all);
    }
    return std::nullopt;
  }

  Controls after(std::uint32_t from, const Controls& rest) const {
    Controls all;
    const std::vector<std::span<const double>> legs = cars_.to_root(from);
    for (std::size_t i = legs.size(); i-- > 0;) all.insert(all.end(), legs[i].begin(), legs[i].end());
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
  }

  const TreeRoom& room_;
  Samples samples_;
  Growth ahead_, behind_;
  Tree cars_, goals_;
};

}  // namespace

std::optional<std::vector<double>> rrt_connect(const TreeRoom& room, const Pose& from, Samples samples) {
  RrtConnect search(room, from, samples);
  auto controls = search.run();
  search.keep(samples.tree);
  return controls;
}

}  // namespace taut::roadblocks::detail
