// RRT by the car's own controls.
#include <numbers>

#include <taut/robots/roadblocks/detail/growth.h>
#include <taut/robots/roadblocks/detail/pose_index.h>

namespace taut::roadblocks::detail {

namespace {

constexpr std::uint32_t kGoalEvery = 20;
constexpr double kFieldAhead = 3;

class Rrt {
 public:
  Rrt(const TreeRoom& room, const Pose& from, Samples samples, bool by_field)
      : room_(room), samples_(samples), by_field_(by_field), growth_(room, Growth::Time::forwards) {
    add({from, kRoot, {}, {}});
  }

  std::optional<std::vector<double>> run() {
    for (std::size_t i = 0; i < samples_.most; ++i) {
      ++samples_.drawn;
      const Pose towards = sample();
      const std::uint32_t from = index_.nearest(towards);
      const auto branch = growth_.towards(towards, nodes_[from].pose, nodes_[from].reach);
      if (!branch) continue;
      add({branch->end, from, branch->controls, {}});
      if (room_.is_goal(branch->end)) return controls_to(nodes_, static_cast<std::uint32_t>(nodes_.size() - 1));
    }
    return std::nullopt;
  }

  void keep(std::vector<TreeBranch>* tree) const {
    for (const Node& node : nodes_)
      if (tree && node.parent != kRoot) tree->push_back(branch_of(nodes_[node.parent].pose, node.controls));
  }

 private:
  struct Node {
    Pose pose;
    std::uint32_t parent;
    std::span<const double> controls;  ///< from the parent
    Reach reach;
  };

  Pose sample() {
    Draws& draws = samples_.draws;
    if (by_field_ && draws.below(2) == 0)
      return room_.ahead(nodes_[draws.below(static_cast<std::uint32_t>(nodes_.size()))].pose, kFieldAhead);
    if (draws.below(kGoalEvery) != 0) return room_.sample(draws);
    return {room_.course().goal.x, room_.course().goal.y, draws.unit() * 2 * std::numbers::pi};
  }

  void add(const Node& node) {
    index_.insert(node.pose, static_cast<std::uint32_t>(nodes_.size()));
    nodes_.push_back(node);
  }

  const TreeRoom& room_;
  Samples samples_;
  bool by_field_;
  Growth growth_;
  std::vector<Node> nodes_;
  PoseIndex index_;
};

}  // namespace

std::optional<std::vector<double>> rrt(const TreeRoom& room, const Pose& from, Samples samples, bool by_field) {
  Rrt search(room, from, samples, by_field);
  auto controls = search.run();
  search.keep(samples.tree);
  return controls;
}

}  // namespace taut::roadblocks::detail
