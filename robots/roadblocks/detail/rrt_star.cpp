// RRT* whose joints are turn, straight, turn, and whose subtrees are simulated anew when they are hung elsewhere.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <taut/robots/roadblocks/detail/growth.h>
#include <taut/robots/roadblocks/detail/pose_index.h>
#include <taut/robots/roadblocks/detail/steering.h>
#include <taut/robots/roadblocks/detail/tree_search.h>

namespace taut::roadblocks::detail {

namespace {

constexpr std::uint32_t kGoalEvery = 20;
constexpr unsigned kNear = 12;
constexpr std::size_t kEnough = 6'000;  // samples with joints, before there is a plan and in all
constexpr std::size_t kLater = 2'000;   // such samples after a plan that came later

class RrtStar {
 public:
  RrtStar(const TreeRoom& room, const Pose& from, Samples samples)
      : room_(room), samples_(samples), growth_(room, Growth::Time::forwards) {
    add({kRoot, 0, from, {}});
  }

  /// Joints first. Where they give no plan, only growth, which is that of RRT and a twentieth of the time, until there
  /// is one; then joints again.
  std::optional<std::vector<double>> run() {
    for (std::size_t joined = 0; joined < kEnough && draw(); ++joined) grow_jointly();
    if (goals_.empty()) {
      while (goals_.empty() && draw()) grow();
      note_goals();
      for (std::size_t joined = 0; joined < kLater && draw(); ++joined) grow_jointly();
    }
    if (goals_.empty()) return std::nullopt;
    return controls_to(nodes_, *std::ranges::min_element(goals_, {}, [&](std::uint32_t n) { return nodes_[n].cost; }));
  }

  void keep(std::vector<TreeBranch>* tree) const {
    for (const Node& node : nodes_)
      if (tree && node.parent != kRoot) tree->push_back(branch_of(nodes_[node.parent].pose, node.controls));
  }

 private:
  struct Node {
    Pose pose;
    std::uint32_t parent;
    int cost;
    std::vector<double> controls;  ///< from the parent
    std::vector<std::uint32_t> children;
    Reach reach;
  };

  /// A way to a pose from some node.
  struct Joint {
    std::uint32_t from = kRoot;
    int cost = 0;
    Pose end;
    std::vector<double> controls;
  };

  bool draw() {
    if (drawn_ == samples_.most) return false;
    ++drawn_;
    ++samples_.drawn;
    return true;
  }

  Pose sample() {
    Draws& draws = samples_.draws;
    if (draws.below(kGoalEvery) != 0) return room_.sample(draws);
    return {room_.course().goal.x, room_.course().goal.y, draws.unit() * 2 * std::numbers::pi};
  }

  std::uint32_t add(Joint by) {
    const auto which = static_cast<std::uint32_t>(nodes_.size());
    if (by.from != kRoot) nodes_[by.from].children.push_back(which);
    index_.insert(by.end, which);
    if (room_.is_goal(by.end)) goals_.push_back(which);
    nodes_.push_back({by.end, by.from, by.cost, std::move(by.controls), {}, {}});
    return which;
  }

  /// The clear joint with the fewest steps, if below `limit` in all.
  std::optional<Joint> joint(std::uint32_t from, const Pose& to, int limit) const {
    const Node& node = nodes_[from];
    const double straight = std::hypot(to.x - node.pose.x, to.y - node.pose.y) - kLanding;
    if (node.cost + straight / kForward >= limit) return std::nullopt;
    for (const Steering& way : steerings(node.pose, to)) {
      if (node.cost + way.steps() >= limit) break;
      Joint found{from, node.cost + way.steps(), {}, way.controls()};
      if (room_.drives(node.pose, found.controls, found.end)) return found;
    }
    return std::nullopt;
  }

  /// Could a way through this pose still be the best? By the disc's way, which may be 8 % too long.
  bool may_improve(const Pose& pose, int cost) const {
    const int rest = room_.distance().steps_from({pose.x, pose.y});
    return rest != DiscDistance::kFar && cost + 0.9 * rest < least_;
  }

  /// As far as growth alone gets.
  std::optional<Joint> grown() {
    const Pose towards = sample();
    const std::uint32_t from = index_.nearest(towards);
    const auto branch = growth_.towards(towards, nodes_[from].pose, nodes_[from].reach);
    if (!branch) return std::nullopt;
    const auto& [to, controls] = *branch;
    return Joint{from, nodes_[from].cost + static_cast<int>(controls.size()), to, {controls.begin(), controls.end()}};
  }

  void grow() {
    if (auto joint = grown()) add(std::move(*joint));
  }

  void grow_jointly() {
    auto best = grown();
    if (!best) return;
    const Pose to = best->end;
    for (const std::uint32_t near : index_.nearest(to, kNear))
      if (auto other = joint(near, to, best->cost)) best = std::move(*other);
    if (may_improve(best->end, best->cost)) rewire(add(std::move(*best)));
  }

  void rewire(std::uint32_t added) {
    note_goals();
    for (const std::uint32_t near : index_.nearest(nodes_[added].pose, kNear)) {
      if (near == added || nodes_[near].parent == kRoot) continue;
      if (auto better = joint(added, nodes_[near].pose, nodes_[near].cost)) hang(near, std::move(*better));
    }
    note_goals();
  }

  void note_goals() {
    for (const std::uint32_t n : goals_) least_ = std::min(least_, nodes_[n].cost);
  }

  /// Hangs a subtree onto another node if all its ways stay clear from where the new way ends. It lands beside its old
  /// place, by at most kLanding.
  void hang(std::uint32_t root, Joint by) {
    std::vector<std::pair<std::uint32_t, Pose>> moved{{root, by.end}};
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const auto [which, pose] = moved[i];
      if (which == by.from || (room_.is_goal(nodes_[which].pose) && !room_.is_goal(pose))) return;
      for (const std::uint32_t child : nodes_[which].children) {
        Pose end;
        if (!room_.drives(pose, nodes_[child].controls, end)) return;
        moved.emplace_back(child, end);
      }
    }
    const int gain = nodes_[root].cost - by.cost;
    for (const auto& [which, pose] : moved) {
      index_.erase(nodes_[which].pose, which);
      index_.insert(pose, which);
      nodes_[which].pose = pose;
      nodes_[which].reach.clear.reset();
      nodes_[which].cost -= gain;
    }
    std::erase(nodes_[nodes_[root].parent].children, root);
    nodes_[by.from].children.push_back(root);
    nodes_[root].parent = by.from;
    nodes_[root].controls = std::move(by.controls);
  }

  const TreeRoom& room_;
  Samples samples_;
  Growth growth_;
  std::vector<Node> nodes_;
  PoseIndex index_;
  std::vector<std::uint32_t> goals_;
  int least_ = 1 << 29;
  std::size_t drawn_ = 0;
};

}  // namespace

std::optional<std::vector<double>> rrt_star(const TreeRoom& room, const Pose& from, Samples samples) {
  RrtStar search(room, from, samples);
  auto controls = search.run();
  search.keep(samples.tree);
  return controls;
}

}  // namespace taut::roadblocks::detail
