#include <taut/robots/roadblocks/detail/door_uct.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace taut::roadblocks::detail {

namespace {

constexpr double kCuriosity = 0.5;  // of the greatest mean of a node's actions

struct Action {
  int node = 0;
  double leg = 0;
  double mean = 0;  ///< before the first drive what the optimist hopes for
  std::size_t taken = 0;
};

struct TreeNode {
  std::vector<Action> actions;
  std::size_t visits = 0;

  Action* next() {
    Action* best = nullptr;
    double least = 0, most = 0;
    for (const Action& action : actions) most = std::max(most, action.mean);
    for (Action& action : actions) {
      const double owed =
          action.taken == 0
              ? DoorGraph::kFar
              : kCuriosity * most *
                    std::sqrt(std::log(static_cast<double>(visits) + 1) / static_cast<double>(action.taken));
      if (!best || action.mean - owed < least) best = &action, least = action.mean - owed;
    }
    return best;
  }
};

class Tree {
 public:
  explicit Tree(DoorGraph& graph) : graph_(graph) {}

  TreeNode node(std::vector<double> legs, const Belief& belief) {
    TreeNode made;
    for (int side = 0; side < graph_.sides(); ++side)
      if (!(belief.open & graph_.door_of(side))) legs[static_cast<std::size_t>(graph_.beyond(side))] = DoorGraph::kFar;
    const std::vector<double> here = graph_.from_here(std::move(legs), belief.open).first;
    const DoorGraph::Ways hope = graph_.ways(belief.open, belief.closed, 0);
    const auto goal = static_cast<std::size_t>(graph_.goal());
    for (int sight = 0; sight < graph_.sides(); ++sight) {
      const auto at = static_cast<std::size_t>(sight);
      if (belief.is_known(graph_.door_of(sight)) || here[at] >= DoorGraph::kFar || hope.steps[at] >= DoorGraph::kFar)
        continue;
      if (here[at] + hope.steps[at] < here[goal])
        made.actions.push_back({sight, here[at], here[at] + hope.steps[at], 0});
    }
    if (here[goal] < DoorGraph::kFar) made.actions.push_back({graph_.goal(), here[goal], here[goal], 0});
    return made;
  }

  /// One drive; every action on the way learns what came of it.
  void drive(TreeNode& root, Belief belief, const World& world) {
    std::vector<std::pair<TreeNode*, Action*>> way;
    std::vector<double> steps;
    double rest = 0;
    for (TreeNode* at = &root;;) {
      Action* action = at->next();
      if (!action) break;
      way.emplace_back(at, action);
      steps.push_back(action->leg);
      if (action->node == graph_.goal()) break;
      if (!(world.doors & graph_.door_of(action->node))) steps.back() += graph_.trap(action->node, world.blocks);
      belief = belief.after(graph_.door_of(action->node), world.doors);
      const auto [next, is_new] = nodes_.try_emplace({action->node, belief.open, belief.closed});
      at = &next->second;
      if (is_new) *at = node(graph_.legs_of(action->node), belief);
      if (is_new || at->actions.empty()) {
        rest = rollout(graph_, action->node, belief, 0, world);
        break;
      }
    }
    for (std::size_t k = way.size(); k-- > 0;) {
      rest += steps[k];
      auto& [at, action] = way[k];
      ++at->visits;
      ++action->taken;
      action->mean =
          action->taken == 1 ? rest : action->mean + (rest - action->mean) / static_cast<double>(action->taken);
    }
  }

 private:
  DoorGraph& graph_;
  std::map<std::tuple<int, DoorSet, DoorSet>, TreeNode> nodes_;
};

}  // namespace

Option uct_option(DoorGraph& graph, const std::vector<double>& legs, const Belief& belief, DoorSet hoped,
                  const std::vector<World>& worlds) {
  Tree tree(graph);
  TreeNode root = tree.node(legs, belief);
  for (std::size_t run = 0; run < kUctRuns && !worlds.empty(); ++run)
    tree.drive(root, belief, worlds[run % worlds.size()]);
  const auto best = std::ranges::max_element(root.actions, {}, &Action::taken);
  if (best == root.actions.end()) return {graph.goal()};
  const bool is_goal = best->node == graph.goal();
  return {best->node, best->mean, 0, !is_goal && graph.door_of(best->node) == hoped};
}

}  // namespace taut::roadblocks::detail
